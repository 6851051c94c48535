import type { Table } from '@botgarten/learning/neural-network/examples'
import { turnOf, type ShownRow, type Turn } from './table.ts'

/** What rows are sorted by: their number, how far Bo is off, or the values of a column (inputs first, then outputs). */
export type SortKey = 'number' | 'error' | number

/** Which rows of a table are seen, and in which order. */
export interface Order {
  readonly by: SortKey
  readonly isDown: boolean
  /** Id of the only drive that is seen; null: all are. */
  readonly drive: string | null
  /** The only way that is seen, where outputs are wheels; null: all are. */
  readonly turn: Turn | null
}

export const asShown: Order = { by: 'number', isDown: false, drive: null, turn: null }

/** The order after a press on a heading: up, down, and as before. */
export function pressed(order: Order, by: SortKey): Order {
  const first = by === 'error'
  if (order.by !== by) return { ...order, by, isDown: first }
  return order.isDown === first ? { ...order, isDown: !first } : { ...order, by: 'number', isDown: false }
}

/** By place in the table: how far off Bo is there, as the mean of the squares. */
export type ErrorsByRow = ReadonlyMap<number, number>

/** null: nothing was practised. */
export const errorsByRow = ({ pairs, errors }: Table): ErrorsByRow | null =>
  errors ? new Map(pairs.map(({ row }, at) => [row, errors[at]!])) : null

interface Known {
  readonly errors: ErrorsByRow | null
  /** Places of the wheels among the outputs. */
  readonly wheels: { readonly left: number; readonly right: number } | null
}

/** The rows that are seen, in their order; equal ones as in the table, gaps last. */
export function inOrder(rows: readonly ShownRow[], order: Order, known: Known): readonly ShownRow[] {
  const seen = rows.filter((row) => isSeen(row, order, known))
  if (order.by === 'number') return order.isDown ? seen.toReversed() : seen
  const sign = order.isDown ? -1 : 1
  const valueOf = (row: ShownRow) => valueIn(row, order.by, known) ?? sign * Infinity
  return seen.toSorted((a, b) => {
    const [left, right] = [valueOf(a), valueOf(b)]
    return left === right ? 0 : sign * (left - right)
  })
}

function isSeen(row: ShownRow, { drive, turn }: Order, { wheels }: Known): boolean {
  if (drive !== null && row.drive.id !== drive) return false
  if (turn === null || !wheels) return true
  return turnOf(row.outputs[wheels.left] ?? 0, row.outputs[wheels.right] ?? 0) === turn
}

function valueIn({ at, number, inputs, outputs }: ShownRow, by: SortKey, { errors }: Known): number | null {
  if (by === 'number') return number
  if (by === 'error') return errors?.get(at) ?? null
  return by < inputs.length ? inputs[by]! : (outputs[by - inputs.length] ?? null)
}

/** What a column comes to: of the values that are there. */
export interface ColumnStatistics {
  readonly mean: number
  /** Standard deviation of all of them (divided by n). */
  readonly spread: number
  readonly least: number
  readonly most: number
}

/** null: no row has a value there. */
export function statisticsOf(values: readonly (number | null)[]): ColumnStatistics | null {
  const known = values.filter((value) => value !== null)
  if (known.length === 0) return null
  const mean = known.reduce((sum, value) => sum + value, 0) / known.length
  const squares = known.reduce((sum, value) => sum + (value - mean) ** 2, 0)
  const [least, most] = known.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity])
  return { mean, spread: Math.sqrt(squares / known.length), least, most }
}
