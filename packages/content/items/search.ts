import type { Item, ItemText } from '../schema/itemTypes.ts'
import { plainOf } from '../schema/markdown.ts'
import { nodesInside } from './walk.ts'

/** Where something was found, best first. */
type Place = 'code' | 'title' | 'kind' | 'section' | 'text'

/** Words of an item that stand together: a line of it, and the number of its section, from 1; 0: before the first one. */
export interface Passage {
  readonly place: Place
  readonly words: string
  readonly section: number
}

/** Where what was looked for stands in an item. `marks`: from and to, in letters of `words`. */
export interface Hit extends Passage {
  readonly score: number
  readonly marks: readonly (readonly [from: number, to: number])[]
}

const points: { readonly [place in Place]: number } = { code: 120, title: 80, kind: 30, section: 10, text: 1 }

/** Words that mean the same, in groups. */
export type Synonyms = readonly (readonly string[])[]

/** Small letters without marks above them, as many as there were: `Größe` and `GRÖSSE` differ in length, `Ä` is `a`. */
export const folded = (text: string): string =>
  Array.from(text, (letter) => {
    const [bare = ''] = letter.toLowerCase().normalize('NFD')
    // Of a few rare signs the bare one is longer than they are: they stay.
    return bare.length > letter.length ? letter : bare.padEnd(letter.length)
  }).join('')

/** All that can be found of an item. `kind`: what its kind is called. */
export function passagesOf(
  { code }: Pick<Item, 'code'>,
  text: ItemText,
  kind: string,
  nameOf: (card: string) => string,
): readonly Passage[] {
  const sections = [{ title: '', body: text.lead, notes: [] }, ...text.sections]
  return [
    ...(code ? [{ place: 'code' as const, words: code, section: 0 }] : []),
    { place: 'title', words: text.title, section: 0 },
    { place: 'kind', words: kind, section: 0 },
    ...sections.flatMap(({ title, body, notes }, section): Passage[] => [
      ...(title ? [{ place: 'section' as const, words: title, section }] : []),
      ...linesIn([...body, ...notes], nameOf).map((words) => ({ place: 'text' as const, words, section })),
    ]),
  ]
}

/** Paragraphs, headings, cells of tables; and the names of cards that are shown. */
const linesIn = (nodes: ItemText['lead'], nameOf: (card: string) => string): readonly string[] =>
  [...nodesInside(nodes)].flatMap((node) => {
    if (node.type === 'paragraph' || node.type === 'heading') return plainOf(node)
    if (node.type === 'table')
      return [node.head, ...node.rows].flatMap((row) => row.map((cell) => cell.map(plainOf).join('')))
    return node.type === 'embed' && 'card' in node.embed ? nameOf(node.embed.card) : []
  })

/**
 * Where the words of a query stand in an item, the best first; none where one of them stands nowhere. A word is found where
 * a word begins with it, a long one (four letters and more) anywhere: German words are put together. A synonym counts like
 * the word itself.
 */
export function search(passages: readonly Passage[], query: string, synonyms: Synonyms = []): readonly Hit[] {
  const asked = askedFor(query, synonyms)
  const found = asked.map((alternatives) => passages.flatMap((one) => hitIn(one, alternatives) ?? []))
  if (found.some((hits) => hits.length === 0)) return []
  const best = new Map<Passage['words'], Hit>()
  for (const hit of found.flat()) {
    const before = best.get(hit.words)
    best.set(hit.words, before ? joined(before, hit) : hit)
  }
  return [...best.values()].sort((a, b) => b.score - a.score)
}

/** How well an item fits: what stands in its title is worth more than what stands often in its text. */
export const scoreOf = (hits: readonly Hit[]): number => (hits[0]?.score ?? 0) + Math.min(hits.length, 9) / 10

const joined = (one: Hit, other: Hit): Hit => ({
  ...one,
  score: one.score + other.score,
  marks: [...one.marks, ...other.marks],
})

/** For each word of a query what may stand for it; a phrase that is a synonym of something stays whole. */
function askedFor(query: string, synonyms: Synonyms): readonly (readonly string[])[] {
  const words = folded(query).trim().split(/\s+/).filter(Boolean)
  const phrase = words.join(' ')
  const same = (word: string) => synonyms.filter((group) => group.some((one) => folded(one) === word))
  const whole = words.length > 1 ? same(phrase) : []
  if (whole.length > 0) return [[phrase, ...whole.flat().map(folded)]]
  // "nn 5" and "NN5" are the code "NN 5".
  if (/^[a-z]{1,2} ?\d+(\.\d)?$/.test(phrase)) return [[phrase.replace(/^([a-z]+) ?/, '$1 ')]]
  return words.map((word) => [word, ...same(word).flat().map(folded)])
}

const isLetter = /[\p{L}\p{N}]/u

/** From where to where one of some words stands in a line. */
function hitIn(passage: Passage, alternatives: readonly string[]): Hit | null {
  const line = folded(passage.words)
  for (const word of alternatives) {
    const at = placeOf(line, word)
    if (at < 0) continue
    const exact = line.trim() === word ? 2 : 1
    return { ...passage, score: points[passage.place] * exact, marks: [[at, at + word.length]] }
  }
  return null
}

function placeOf(line: string, word: string): number {
  const short = word.length < 4
  for (let at = line.indexOf(word); at >= 0; at = line.indexOf(word, at + 1))
    if (at === 0 || !isLetter.test(line[at - 1]!)) {
      // A number that goes on is another number: "3.1" is not in "3.12".
      if (!/\d$/.test(word) || !/^\d/.test(line.slice(at + word.length))) return at
    }
  return short ? -1 : line.indexOf(word)
}
