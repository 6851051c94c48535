import materials from 'content:items'
import {
  linesFor,
  nodesOf,
  printingOf,
  timesIn,
  type Item,
  type PackLine,
  type Printing,
} from '@botgarten/content/items'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'
import { allItems, itemNamed, targetItem, textOf } from '../library.ts'
import { mySet } from '../library/my-set.svelte.ts'
import { pagesOf } from '../plan/parts.ts'

/** What is printed together. */
export interface Pack {
  readonly id: string
  readonly title: string
  /** Of a lesson: its plan. */
  readonly plan: Item | null
  readonly lines: readonly PackLine[]
}

const isAnswers = (of: string) => targetItem(of)?.kind === 'solution'

/** Packs that belong to no lesson. */
export const fixedPacks = materials.packs

/** Every pack but one's own set, by its id: that of a lesson has the id of its plan. */
export const packIds = (): readonly string[] => [
  ...allItems.filter(({ plan }) => plan).map(({ id }) => id),
  ...fixedPacks.map(({ id }) => id),
]

/** Id of the pack that is the set of this device. */
export const ownPack = 'my-set'

/** A pack by its id; null where there is none. Decks that a plan leads to lie in it as small pictures. */
export function packNamed(id: string): Pack | null {
  if (id === ownPack)
    return { id, title: mySet.kept.name || m['materials.set.title'](), plan: null, lines: mySet.lines }
  const fixed = fixedPacks.find((one) => one.id === id)
  if (fixed) {
    const title = fixed.title[language.locale] ?? fixed.title['en']!
    return { id, title, plan: null, lines: fixed.copies }
  }
  const item = itemNamed(id)
  if (!item?.plan) return null
  const decks = ledTo(item).filter((one) => one.kind === 'slides')
  const lines = linesFor(item.plan, isAnswers)
  const slides = decks.map((deck): PackLine => ({ of: `item:${deck.id}`, for: 'teacher' }))
  const at = lines.findIndex(({ of }) => isAnswers(of))
  const place = at < 0 ? lines.length : at
  return {
    ...{ id, title: textOf(item).title, plan: item },
    lines: [...lines.slice(0, place), ...slides, ...lines.slice(place)],
  }
}

/** Items that a text leads to and does not copy, each once. */
export function ledTo(item: Item): readonly Item[] {
  const copied = new Set(item.plan?.copies.map(({ of }) => of))
  const links = [...nodesOf(textOf(item))].flatMap((node) => (node.type === 'link' ? [node.href] : []))
  return [...new Set(links)]
    .filter((href) => /^(item|card):/.test(href) && !copied.has(href))
    .flatMap((href) => targetItem(href) ?? [])
}

/** A line of a pack with all that its cover says of it. */
export interface Printed extends Printing {
  readonly line: PackLine
  readonly item: Item
  readonly title: string
  /** Is it for the teacher alone, in a file of its own where one is asked for? */
  readonly answers: boolean
  /** Its first page in the file, from 1. */
  readonly from: number
  readonly times: number
}

export function printedOf(
  { lines }: Pack,
  children: number,
  paper: 'a4' | 'a5',
  firstPage: number,
): readonly Printed[] {
  let from = firstPage
  return lines.map((line) => {
    const item = targetItem(line.of)!
    const times = timesIn(line, children)
    const printing = printingOf(item.paper, pagesOf(item), times, paper === 'a4')
    const printed = { ...printing, line, item, times, from, title: textOf(item).title }
    from += printing.pages
    return { ...printed, answers: isAnswers(line.of) }
  })
}

export const sheetsOf = (printed: readonly Printed[]): number =>
  printed.reduce((sum, { sheets }) => sum + sheets, 0)
