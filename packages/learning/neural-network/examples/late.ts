import { headOfRow, place, type Examples, type Row } from './types.ts'

/** Ways to show in which a hand follows what it sees. */
const byHand: readonly string[] = ['keys', 'pad', 'touch', 'coach']

/**
 * The table against a late hand: in every drive by hand each row gets the wishes that were held so many ticks later, where the
 * drive still went on. A row that says the same again is not written, so that wishes hold until the next row.
 */
export function withEarlierWishes(examples: Examples, ticks: number): Examples {
  const { drives, rows, inputs } = examples
  const from = headOfRow + inputs.length
  const later = rows.map((row, at) =>
    byHand.includes(drives[row[place.drive]!]!.by) ? heldLater(rows, at, ticks) : row,
  )
  return {
    ...examples,
    rows: rows.map((row, at) => [...row.slice(0, from), ...later[at]!.slice(from)]),
  }
}

/** The last row of the same drive that was written until so many ticks after this one. */
function heldLater(rows: readonly Row[], at: number, ticks: number): Row {
  const own = rows[at]!
  const end = own[place.tick]! + ticks
  let last = at
  while (isBefore(rows[last + 1], own[place.drive]!, end)) last++
  return rows[last]!
}

const isBefore = (row: Row | undefined, drive: number, end: number) =>
  row !== undefined && row[place.drive] === drive && row[place.tick]! <= end
