import {
  codeOfAll,
  printingOf,
  sidesIn,
  timesIn,
  type Copies,
  type Item,
  type ItemMarkdown,
  type ItemNode,
  type PackLine,
} from '@botgarten/content/items'
import { language, type Locale } from '#words/language.svelte.ts'
import { nameOfTarget } from '../addresses.ts'
import { targetItem, textOf } from '../library.ts'
import { slidesOf } from '../slides/deck.ts'

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
/** So many small slides stand on a page. */
export const slidesOnPage = 12

/** Pages of an item as it is printed with others, in a language: of slides, as small pictures. */
export function pagesOf(item: Item, locale: Locale = language.locale): number {
  if (item.plan) return planSides
  if (item.paper !== '16:9') return sidesIn(item, textOf(item), locale)
  return Math.ceil(slidesOf(textOf(item)).length / slidesOnPage)
}

/** A line of what is printed together, with how often, and how many sheets that makes. */
export function copiedOf(copies: PackLine, of = children): Copied {
  const item = targetItem(copies.of)!
  const times = timesIn(copies, of)
  return {
    ...{ target: copies.of, times, for: copies.for, name: nameOfTarget(copies.of) },
    code: codeOfAll(item) ?? '',
    sheets: printingOf(item.paper, pagesOf(item), times).sheets,
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
