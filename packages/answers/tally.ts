import { bands as allBands, type Band } from './atoms.ts'
import { valueOf } from './columns.ts'
import { countsOf, sumOf } from './count.ts'
import type { Release } from './release.ts'
import { shuffled } from './shuffle.ts'
import { fewest, type Answer, type Chance, type Column } from './types.ts'

/** What a group of at least five people answered. */
export interface Tally {
  /** The grades among them, in order. */
  readonly bands: readonly Band[]
  /** How many people. */
  readonly n: number
  /** By item that can be counted, how often each option was chosen: never of fewer than five people. */
  readonly counts: { readonly [item: string]: readonly number[] }
  /** Sentences by item: never of fewer than five people. */
  readonly open: { readonly [item: string]: readonly string[] }
}

/** Counts from paper: nothing else is known of who gave them. */
export interface PaperCounts extends Tally {
  readonly form: string
}

/** What is known of the answers to some forms, and how much of it is published. */
export interface Published {
  readonly answers: readonly Answer[]
  readonly release: Release
  readonly paper: readonly PaperCounts[]
}

/** The answers with these ids, in the order of the answers. */
export function among(answers: readonly Answer[], ids: readonly string[]): readonly Answer[] {
  const wanted = new Set(ids)
  return answers.filter(({ id }) => wanted.has(id))
}

/** What a whole group answered to an item; nothing where fewer than five of it answered. */
export function valuesOf(column: Column, answers: readonly Answer[]): readonly string[] {
  const values = answers.flatMap((answer) => valueOf(column, answer) ?? [])
  return values.length < fewest ? [] : values
}

function tallyOf(columns: readonly Column[], bands: readonly Band[], answers: readonly Answer[]): Tally {
  const open = columns.filter(({ kind }) => kind === 'text')
  const counted = columns.filter(({ kind }) => kind !== 'text')
  const byItem = <Of>(some: readonly Column[], of: (column: Column) => Of) =>
    Object.fromEntries(some.map((column) => [column.id, of(column)]))
  return {
    ...{ bands, n: answers.length },
    counts: byItem(counted, (column) => countsOf(column.options, valuesOf(column, answers))),
    open: byItem(open, (column) => valuesOf(column, answers)),
  }
}

/** Counts of fewer than five people are left out, as those of a batch are. */
function withoutFew({ counts, open, ...rest }: Tally): Tally {
  const large = <Values>(table: { readonly [item: string]: Values }, size: (values: Values) => number) =>
    Object.fromEntries(Object.entries(table).filter(([, values]) => size(values) >= fewest))
  return { ...rest, counts: large(counts, sumOf), open: large(open, ({ length }) => length) }
}

function plus(a: Tally, b: Tally): Tally {
  const items = (table: 'counts' | 'open') => [...new Set([a, b].flatMap((one) => Object.keys(one[table])))]
  const added = (item: string) => {
    const [some, more] = [a.counts[item] ?? [], b.counts[item] ?? []]
    return (some.length < more.length ? more : some).map((_, at) => (some[at] ?? 0) + (more[at] ?? 0))
  }
  return {
    bands: allBands.filter((band) => a.bands.includes(band) || b.bands.includes(band)),
    n: a.n + b.n,
    counts: Object.fromEntries(items('counts').map((item) => [item, added(item)])),
    open: Object.fromEntries(
      items('open').map((item) => [item, [...(a.open[item] ?? []), ...(b.open[item] ?? [])]]),
    ),
  }
}

const overlaps = (a: Tally, b: Tally) => a.bands.some((band) => b.bands.includes(band))

/** Groups that share a grade are one. */
const joined = (tallies: readonly Tally[]): readonly Tally[] =>
  tallies.reduce<readonly Tally[]>((all, one) => {
    const same = all.filter((other) => overlaps(other, one))
    return [...all.filter((other) => !same.includes(other)), same.reduce(plus, one)]
  }, [])

/** What is published of a form, by grade. Groups have no grade in common. */
export function talliesOf(
  form: string,
  columns: readonly Column[],
  { answers, release, paper }: Published,
): readonly Tally[] {
  const typed = paper.filter((one) => one.form === form && one.n >= fewest).map(withoutFew)
  const batches = release.batches
    .filter((batch) => batch.form === form)
    .map(({ bands, ids }) => tallyOf(columns, bands, among(answers, ids)))
  const first = ({ bands }: Tally) => allBands.indexOf(bands[0]!)
  return [...joined([...batches, ...typed])].sort((a, b) => first(a) - first(b))
}

/** Sentences of each item in an order of their own: beside each other they would say what one child wrote. */
export const mixed = (tally: Tally, chance: Chance): Tally => ({
  ...tally,
  open: Object.fromEntries(
    Object.entries(tally.open).map(([item, sentences]) => [item, shuffled(sentences, chance)]),
  ),
})

/** All groups as one; null where there are none. */
export const total = ([first, ...others]: readonly Tally[]): Tally | null =>
  first ? others.reduce(plus, first) : null
