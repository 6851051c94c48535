import { groupBy } from '@botgarten/browsers'
import materials from 'content:items'
import {
  atGrade,
  linesFor,
  nodesOf,
  printingOf,
  timesIn,
  type Item,
  type PackLine,
  type Printing,
} from '@botgarten/content/items'
import { language, type Locale } from '#words/language.svelte.ts'
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
const fixedPacks = materials.packs

/** Plans of the double lessons, by the id of their pack: `double-a`. */
const doubles = (): ReadonlyMap<string, readonly Item[]> =>
  groupBy(
    allItems.filter(({ plan }) => plan?.double),
    ({ plan }) => `double-${plan!.double!.name.toLowerCase()}`,
  )

/** Packs that are no single lesson's. */
export const readyPacks = (): readonly string[] => [...doubles().keys(), ...fixedPacks.map(({ id }) => id)]

/** Every pack but one's own set, by its id: that of a lesson has the id of its plan. */
export const packIds = (): readonly string[] => [
  ...allItems.filter(({ plan }) => plan).map(({ id }) => id),
  ...readyPacks(),
]

/** Id of the pack that is the set of this device. */
export const ownPack = 'my-set'

/** Of sheets with reading levels the one for this grade; without a grade the middle one. */
const leveled = (lines: readonly PackLine[], grade: number | null): readonly PackLine[] =>
  lines.map((line) => {
    const item = targetItem(line.of)
    return item?.levels ? { ...line, of: `item:${atGrade(item, grade)}` } : line
  })

/** Are there sheets in it that are written for several grades? */
export const hasLevels = ({ id, lines }: Pack): boolean =>
  id !== ownPack && lines.some(({ of }) => targetItem(of.replace(/-[ac]$/, ''))?.levels)

/** The answers to the sheets of a lesson, where its plan does not copy them already. */
function answersTo({ plan }: Item): readonly PackLine[] {
  const answers = allItems.find(({ kind, code }) => kind === 'solution' && code === `A ${plan!.lesson}`)
  const of = `item:${answers?.id}`
  return !answers || plan!.copies.some((one) => one.of === of) ? [] : [{ of, for: 'teacher' }]
}

/**
 * A pack by its id, for a grade; null where there is none. Decks that a plan leads to lie in it as small pictures, and the
 * answers to its sheets lie last.
 */
export function packNamed(id: string, grade: number | null = null): Pack | null {
  if (id === ownPack)
    return { id, title: mySet.kept.name || m['materials.set.title'](), plan: null, lines: mySet.lines }
  const fixed = fixedPacks.find((one) => one.id === id)
  if (fixed) {
    const title = fixed.title[language.locale] ?? fixed.title['en']!
    return { id, title, plan: null, lines: fixed.copies }
  }
  const halves = doubles().get(id)
  if (halves) return doublePack(id, halves, grade)
  const item = itemNamed(id)
  if (!item?.plan) return null
  return { id, title: textOf(item).title, plan: item, lines: leveled(linesOfLesson(item), grade) }
}

/** All that a lesson needs, answers last. */
function linesOfLesson(item: Item): readonly PackLine[] {
  const decks = ledTo(item).filter((one) => one.kind === 'slides')
  const lines = linesFor(item.plan!, isAnswers)
  const slides = decks.map((deck): PackLine => ({ of: `item:${deck.id}`, for: 'teacher' }))
  const at = lines.findIndex(({ of }) => isAnswers(of))
  const place = at < 0 ? lines.length : at
  return [...lines.slice(0, place), ...slides, ...lines.slice(place), ...answersTo(item)]
}

/** Both halves of a double lesson; what they share is printed once. */
function doublePack(id: string, halves: readonly Item[], grade: number | null): Pack {
  const { name, lessons } = halves[0]!.plan!.double!
  const [first, second] = lessons
  const all = new Map(halves.flatMap(linesOfLesson).map((line) => [line.of, line]))
  const lines = [...all.values()].toSorted((a, b) => Number(isAnswers(a.of)) - Number(isAnswers(b.of)))
  return {
    ...{ id, title: m['materials.plan.double']({ name, first, second }), plan: null },
    lines: leveled(lines, grade),
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

/** A line of a pack in a language, with all that its cover says of it. */
export interface Printed extends Printing {
  /** Of this line in this language. */
  readonly key: string
  readonly line: PackLine
  readonly locale: Locale
  readonly item: Item
  readonly title: string
  /** Is it for the teacher alone, in a file of its own where one is asked for? */
  readonly answers: boolean
  /** Its first page in the file, from 1. */
  readonly from: number
  /** Copies in one set. */
  readonly times: number
}

/** For whom a pack is printed, and on what. */
interface Printer {
  readonly children: number
  readonly paper: 'a4' | 'a5'
  /** All of it so many times. */
  readonly sets: number
  /** All of it in each of these, line by line. */
  readonly locales: readonly Locale[]
}

/** Every line of a pack in every language; `firstPage`: the page of its file on which the first of them begins. */
export function printedOf({ lines }: Pack, printer: Printer, firstPage = 2): readonly Printed[] {
  let from = firstPage
  const all = lines.flatMap((line) => printer.locales.map((locale) => ({ line, locale })))
  return all.map(({ line, locale }) => {
    const printed = { ...oncePrinted(line, locale, printer), from }
    from += printed.pages
    return printed
  })
}

function oncePrinted(line: PackLine, locale: Locale, { children, paper, sets }: Printer) {
  const item = targetItem(line.of)!
  const times = timesIn(line, children)
  const once = printingOf(item.paper, pagesOf(item, locale), times, paper === 'a4')
  const printing = { pages: once.pages, prints: sets * once.prints, sheets: sets * once.sheets }
  const named = { key: `${line.of} ${locale}`, title: textOf(item).title, answers: isAnswers(line.of) }
  return { ...printing, ...named, line, locale, item, times }
}

export const sheetsOf = (printed: readonly Printed[]): number =>
  printed.reduce((sum, { sheets }) => sum + sheets, 0)
