import { bucketsOf, statesOf, type TableBrain } from '@botgarten/learning/q-senses'
import type { Fan } from '#drawing/fan.ts'

/** What one move is worth in one case. */
export interface Cell {
  readonly value: number
  readonly tries: number
  /** Bo takes it when it does not explore, alone or as one of several by a draw. */
  readonly best: boolean
}

export interface Row {
  /** Bucket of each sensor; null: the bump. */
  readonly buckets: readonly number[] | null
  readonly cells: readonly Cell[]
}

export const cellAt = ({ actions }: TableBrain, state: number, action: number): number =>
  state * actions.length + action

/** The table as it is shown, a row a state. Of a trial that cannot be learned it has none. */
export function rowsOf(table: TableBrain): readonly Row[] {
  const count = table.actions.length
  return Array.from({ length: count === 0 ? 0 : table.q.length / count }, (_, state) => {
    const values = table.q.slice(state * count, (state + 1) * count)
    const most = Math.max(...values)
    const cells = values.map((value, action) => {
      const tries = table.tries[state * count + action]!
      return { value, tries, best: tries > 0 && value === most }
    })
    return { buckets: bucketsOf(table, state), cells }
  })
}

const sameCell = (one: Cell, other: Cell) =>
  one.value === other.value && one.tries === other.tries && one.best === other.best
const sameRow = (one: Row | undefined, other: Row) =>
  String(one?.buckets) === String(other.buckets) &&
  one!.cells.length === other.cells.length &&
  other.cells.every((cell, action) => sameCell(one!.cells[action]!, cell))

/** Rows of now; those in which nothing has changed are the objects of before, so that they are not drawn again. */
export function keepRows(before: readonly Row[], now: readonly Row[]): readonly Row[] {
  const kept = now.map((row, state) => (sameRow(before[state], row) ? before[state]! : row))
  return kept.length === before.length && kept.every((row, state) => row === before[state]) ? before : kept
}

/** The one action that is taken in a state; null where none is known, or several are worth the same. */
export function bestOf({ cells }: Row): number | null {
  const best = cells.flatMap(({ best }, action) => (best ? [action] : []))
  return best.length === 1 ? best[0]! : null
}

/**
 * The fields before the robot: those of its first two sensors, a third one as it senses now.
 * @param flips is the first of the two eyes the right one?
 */
export function fanOf(table: TableBrain, rows: readonly Row[], state: number | null, flips: boolean): Fan {
  const now = state === null ? null : (rows[state]?.buckets ?? null)
  const [first = 0, second = 0, third] = table.edges.map(({ length }) => length + 1)
  const slice = now?.[2] ?? 0
  const at = (a: number, b: number) => {
    const row = rows[(a * Math.max(1, second) + b) * (third ?? 1) + (third ? slice : 0)]
    return row ? bestOf(row) : null
  }
  const lengths = flips ? [second, first] : [first, Math.max(1, second)]
  const fields = Array.from({ length: lengths[0]! }, (_, left) =>
    Array.from({ length: lengths[1]! }, (_, right) => (flips ? at(right, left) : at(left, right))),
  )
  const lit = now && ([now[0]!, now[1] ?? 0] as const)
  return { fields, now: lit && (flips ? [lit[1], lit[0]] : lit), actions: table.actions }
}

/** Buckets of each sensor, whether a bump is one state more, and how many states that makes. */
export const sizeOf = (trial: Pick<TableBrain, 'edges' | 'bump'>) => ({
  buckets: trial.edges.map(({ length }) => length + 1),
  bump: trial.bump,
  states: statesOf(trial),
})
