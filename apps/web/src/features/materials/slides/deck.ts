import type { ItemMarkdown, ItemText } from '@botgarten/content/items'
import type { BoPose } from '#parts/bo.ts'

export interface Slide {
  readonly title: string
  readonly words: ItemMarkdown
  /** What is drawn or worked with: beside the words. */
  readonly shown: ItemMarkdown
  readonly notes: ItemMarkdown
  readonly first: boolean
}

/** A picture is written as a paragraph of its own. */
const unwrapped = (node: ItemMarkdown[number]) =>
  node.type === 'paragraph' && node.children.length === 1 && node.children[0]!.type === 'image'
    ? node.children[0]!
    : node

const isShown = ({ type }: ItemMarkdown[number]) => type === 'embed' || type === 'image'
const isTurn = (node: ItemMarkdown[number]) => node.type === 'embed' && node.embed.kind === 'page'

/** A deck as its slides: the title and what stands below it, then one for every section. */
export function slidesOf({ title, lead, sections }: ItemText): readonly Slide[] {
  const slide = (title: string, written: ItemMarkdown, notes: ItemMarkdown, first: boolean): Slide => {
    const body = written.map(unwrapped)
    const words = body.filter((node) => !isShown(node))
    return { title, words, shown: body.filter((node) => isShown(node) && !isTurn(node)), notes, first }
  }
  return [
    slide(title, lead, [], true),
    ...sections.map((section) => slide(section.title, section.body, section.notes, false)),
  ]
}

/** Is a slide worked with, so that what it shows has the room below its words? */
export const isWorkedWith = ({ shown }: Slide): boolean =>
  shown.some(
    (node) =>
      node.type === 'embed' && ['live', 'questions', 'race', 'sort', 'trials'].includes(node.embed.kind),
  )

/** How Bo stands on the slide with this number: Bo greets on the first one and thinks at a question. */
export function poseOn({ first, title }: Slide, number: number): BoPose {
  if (first) return 'wave'
  if (title.endsWith('?')) return 'think'
  return number % 2 ? 'cheer' : 'wave'
}

type Step = 'next' | 'before' | 'first' | 'last'

const steps: { readonly [key: string]: Step | undefined } = {
  ...{ ArrowRight: 'next', ArrowDown: 'next', PageDown: 'next', ' ': 'next' },
  ...{ ArrowLeft: 'before', ArrowUp: 'before', PageUp: 'before' },
  ...{ Home: 'first', End: 'last' },
}

/** The slide a key leads to, from 0; null for a key that turns nothing. */
export function turned(key: string, at: number, count: number): number | null {
  const step = steps[key]
  if (!step) return null
  const to = { next: at + 1, before: at - 1, first: 0, last: count - 1 }[step]
  return Math.max(0, Math.min(count - 1, to))
}

/** Turns to the slide a key leads to. Returns whether there is one. */
export function turnBy(key: string, at: number, count: number, onturn: (at: number) => void): boolean {
  const to = turned(key, at, count)
  if (to !== null) onturn(to)
  return to !== null
}
