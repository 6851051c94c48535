import { valueOf } from './columns.ts'
import { shuffled } from './shuffle.ts'
import { among, valuesOf, type Published, type Tally } from './tally.ts'
import type { Answer, Chance, Column } from './types.ts'

/** What a spreadsheet would take for a formula is text. */
const harmless = (text: string) => (/^[=+\-@\t\r]/.test(text) ? `'${text}` : text)

const cell = (value: string | number): string => {
  const text = typeof value === 'number' ? String(value) : harmless(value)
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** A table as CSV (RFC 4180), with a mark of UTF-8 in front for spreadsheets. */
export const csv = (rows: readonly (readonly (string | number)[])[]): string =>
  `\uFEFF${rows.map((row) => row.map(cell).join(',')).join('\r\n')}\r\n`

const gradesOf = ({ bands }: Pick<Tally, 'bands'>) => bands.join(' ')

/** The group of a table that a batch is counted in. */
const groupOf = (tallies: readonly Tally[], { bands }: Pick<Tally, 'bands'>) =>
  tallies.find((tally) => bands.some((band) => tally.bands.includes(band)))!

/**
 * A row for every child whose answers are published: grades and what was chosen. No code, no day, no sentence; in random
 * order.
 */
export function rowsOf(
  form: string,
  columns: readonly Column[],
  tallies: readonly Tally[],
  { answers, release }: Published,
  chance: Chance,
): readonly (readonly (string | number)[])[] {
  const counted = columns.filter(({ kind }) => kind !== 'text')
  const rows = release.batches
    .filter((batch) => batch.form === form)
    .flatMap((batch) => {
      const own = among(answers, batch.ids)
      const shown = counted.filter((column) => valuesOf(column, own).length > 0)
      const valueIn = (column: Column, answer: Answer) =>
        shown.includes(column) ? (valueOf(column, answer) ?? '') : ''
      const grades = gradesOf(groupOf(tallies, batch))
      return own.map((answer) => [grades, ...counted.map((column) => valueIn(column, answer))])
    })
  return [['grades', ...counted.map(({ id }) => id)], ...shuffled(rows, chance)]
}

/** Counts of every group, an option a row: also those from paper. */
export const countsTable = (
  columns: readonly Column[],
  tallies: readonly Tally[],
): readonly (readonly (string | number)[])[] => [
  ['grades', 'people', 'item', 'option', 'count'],
  ...tallies.flatMap((tally) =>
    columns.flatMap(({ id, options }) =>
      (tally.counts[id] ?? []).map((count, at) => [gradesOf(tally), tally.n, id, options[at]!, count]),
    ),
  ),
]

/** Sentences of an item, each a row, in random order. */
export const sentencesTable = (
  item: string,
  tally: Tally | null,
  chance: Chance,
): readonly (readonly string[])[] => [
  [item],
  ...shuffled(tally?.open[item] ?? [], chance).map((sentence) => [sentence]),
]
