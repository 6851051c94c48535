import { resolve } from '$app/paths'
import { passagesOf, scoreOf, search, type Hit, type Item, type Passage } from '@botgarten/content/items'
import { titleOf } from '#content/names.ts'
import { language } from '#words/language.svelte.ts'
import { message } from '#words/message.ts'
import { offeredItems, synonyms, targetOf, textOf } from '../library.ts'
import { fits, type Choice } from './choice.ts'

/** An item that fits, and where what was looked for stands in it; nothing where nothing was looked for. */
export interface Found {
  readonly item: Item
  readonly hits: readonly Hit[]
}

/** What can be found of each item, by what it is named by: made once a language. */
const passages = new Map<string, ReadonlyMap<string, readonly Passage[]>>()

function allPassages(): ReadonlyMap<string, readonly Passage[]> {
  const made = passages.get(language.locale)
  if (made) return made
  const all = new Map(
    offeredItems.map((item) => [
      targetOf(item),
      passagesOf(item, textOf(item), message(`materials.kind.${item.kind}`), titleOf),
    ]),
  )
  passages.set(language.locale, all)
  return all
}

/** Items in which the words stand, the best first; all of them where there are no words. */
export function foundBy(words: string): readonly Found[] {
  if (words.trim() === '') return offeredItems.map((item) => ({ item, hits: [] }))
  const all = allPassages()
  const groups = synonyms()
  return offeredItems
    .map((item) => ({ item, hits: search(all.get(targetOf(item))!, words, groups) }))
    .filter(({ hits }) => hits.length > 0)
    .sort((a, b) => scoreOf(b.hits) - scoreOf(a.hits))
}

/** A page of the lab that the library leads to. */
export interface FoundPage {
  readonly href: string
  readonly title: string
  readonly text: string
}

/** Pages that are no materials: questionnaires and studies. */
export const otherPages = (): readonly FoundPage[] => [
  {
    href: resolve('/questionnaires'),
    title: message('materials.questionnaires'),
    text: message('materials.questionnairesText'),
  },
  { href: resolve('/study'), title: message('materials.study'), text: message('materials.studyText') },
]

/** The pages that have the words of a query; none for an empty query. */
export function pagesFor(words: string): readonly FoundPage[] {
  if (words.trim() === '') return []
  const groups = synonyms()
  return otherPages().filter(({ title, text }) => {
    const lines = [title, text].map((line) => ({ place: 'title' as const, words: line, section: 0 }))
    return search(lines, words, groups).length > 0
  })
}

/** How many of what was found would be there if a filter had this value alone. */
export const countWith = (found: readonly Found[], choice: Choice, part: Partial<Choice>): number =>
  found.filter(({ item }) => fits(item, { ...choice, ...part })).length

/** A line in pieces, those that were looked for marked; cut to what stands around the first of them. */
export function marked({ words, marks }: Pick<Hit, 'words' | 'marks'>, most = 64) {
  const sorted = marks.toSorted(([a], [b]) => a - b)
  const from = words.length <= most ? 0 : beginNear(words, (sorted[0]?.[0] ?? 0) - most / 3)
  const to = Math.min(words.length, from + most)
  const pieces: { readonly text: string; readonly on: boolean }[] = []
  let at = from
  for (const [begin, end] of sorted) {
    if (begin < at || begin >= to) continue
    pieces.push({ text: words.slice(at, begin), on: false }, { text: words.slice(begin, end), on: true })
    at = end
  }
  pieces.push({ text: words.slice(at, Math.max(at, to)), on: false })
  return {
    ...{ before: from > 0, after: Math.max(at, to) < words.length },
    pieces: pieces.filter(({ text }) => text !== ''),
  }
}

/** Where a word begins, at this letter or before it. */
const beginNear = (words: string, at: number) => (at <= 0 ? 0 : words.lastIndexOf(' ', Math.round(at)) + 1)
