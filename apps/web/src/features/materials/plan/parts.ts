import { sheetsFor, timesOf, type Copies, type ItemMarkdown, type ItemNode } from '@botgarten/content/items'
import { allCards } from '#content/cards.ts'
import { nameOfTarget } from '../addresses.ts'
import { itemNamed, textOf } from '../library.ts'
import { sidesOf } from '../sides.ts'

/** A class as plans count it. */
export const children = 24

/** What is copied, as a line of the list. */
export interface Copied {
  readonly target: string
  readonly code: string
  readonly name: string
  readonly times: number
  readonly for: Copies['for']
  /** Of A4. */
  readonly sheets: number
}

const planSides = 2
const cardSides = 2

export function copiedOf(copies: Copies): Copied {
  const [kind, id] = copies.of.split(':') as [string, string]
  const item = kind === 'item' ? itemNamed(id) : undefined
  const sides = !item ? cardSides : item.plan ? planSides : sidesOf(textOf(item)).length
  const times = timesOf(copies, children)
  return {
    ...{ target: copies.of, times, for: copies.for, name: nameOfTarget(copies.of) },
    code: item?.code ?? allCards.find((card) => card.id === id)?.code ?? '',
    sheets: sheetsFor(item?.paper ?? 'a5', sides, times),
  }
}

/** Words, then pictures with what stands below each. */
export function withPictures(body: ItemMarkdown) {
  const first = body.findIndex(({ type }) => type === 'embed')
  const words = first < 0 ? body : body.slice(0, first)
  const pictures: { readonly picture: ItemNode; readonly below: ItemNode[] }[] = []
  for (const node of first < 0 ? [] : body.slice(first))
    if (node.type === 'embed') pictures.push({ picture: node, below: [] })
    else pictures.at(-1)!.below.push(node)
  return { words, pictures }
}

/** What a teacher says, hears or does, one after the other. */
export interface Line {
  readonly kind: 'say' | 'expect' | 'note' | 'plain'
  /** Of a note: what it is about. */
  readonly name?: string
  readonly words: ItemMarkdown
}

const childrenOf = (node: ItemNode | undefined): ItemMarkdown =>
  node && 'children' in node ? node.children : []

/** Blockquotes are said, lists are expected, what begins with emphasis is a note. */
export function linesOf(body: ItemMarkdown): readonly Line[] {
  return body.flatMap((node): Line | Line[] => {
    if (node.type === 'blockquote') return { kind: 'say', words: node.children.flatMap(childrenOf) }
    if (node.type === 'list')
      return node.children.map((item) => ({
        kind: 'expect' as const,
        words: childrenOf(item).flatMap((one) => (one.type === 'paragraph' ? one.children : [one])),
      }))
    const [first, ...rest] = childrenOf(node)
    if (node.type === 'paragraph' && first?.type === 'emphasis')
      return { kind: 'note', name: textIn(first), words: rest }
    return { kind: 'plain', words: childrenOf(node) }
  })
}

/** Lines that stand in one paragraph: what is said with what is expected, a note by itself. */
export function paragraphsOf(lines: readonly Line[]): readonly (readonly Line[])[] {
  const all: Line[][] = []
  for (const line of lines) {
    const last = all.at(-1)
    const begins = line.kind === 'note' || (line.kind === 'say' && last?.some(({ kind }) => kind !== 'plain'))
    if (!last || begins || last.some(({ kind }) => kind === 'note')) all.push([line])
    else last.push(line)
  }
  return all
}

const textIn = (node: ItemNode): string =>
  node.type === 'text' ? node.value : childrenOf(node).map(textIn).join('')

/** `Look back · board`: what happens, and with what. */
export function titleOfStep(title: string): readonly [title: string, medium: string] {
  const at = title.lastIndexOf(' · ')
  return at < 0 ? [title, ''] : [title.slice(0, at), title.slice(at + 3)]
}
