import {
  headOfRow,
  place,
  type Drive,
  type Examples,
  type Row,
} from '@botgarten/learning/neural-network/examples'
import type { Pose } from '@botgarten/simulation'

/** A row as a child sees it. Values in percent by the neurons on the screen; null where it has a gap. */
export interface ShownRow {
  /** Place in the table, and the number that it is called by. */
  readonly at: number
  readonly number: number
  readonly on: boolean
  readonly drive: Drive
  readonly inputs: readonly (number | null)[]
  readonly outputs: readonly (number | null)[]
  /** null: it came from a table without poses. */
  readonly pose: Pose | null
}

/** The rows with the columns of these neurons, in their order. */
export function shownRows(
  examples: Examples,
  inputs: readonly string[],
  outputs: readonly string[],
): readonly ShownRow[] {
  const columnsOf = (ids: readonly string[], all: readonly string[], before: number) =>
    ids.map((id) => (all.includes(id) ? before + all.indexOf(id) : -1))
  const ins = columnsOf(inputs, examples.inputs, headOfRow)
  const outs = columnsOf(outputs, examples.outputs, headOfRow + examples.inputs.length)
  const pick = (row: Row, columns: readonly number[]) => columns.map((column) => row[column] ?? null)
  return examples.rows.map((row, at) => ({
    ...{ at, number: at + 1, on: row[place.on] === 1, drive: examples.drives[row[place.drive]!]! },
    ...{ inputs: pick(row, ins), outputs: pick(row, outs), pose: poseOf(row) },
  }))
}

function poseOf(row: Row): Pose | null {
  const [x, y, heading] = [row[place.x]!, row[place.y]!, row[place.heading]!]
  return x === 0 && y === 0 ? null : { x, y, heading }
}

/** The table with one number of a row changed; `to` null is a gap. */
function withValue(examples: Examples, at: number, column: number, to: number | null): Examples {
  const row = examples.rows[at]
  if (!row || row[column] === to) return examples
  const rows = examples.rows.with(
    at,
    row.map((value, k) => (k === column ? to : value)),
  )
  return { ...examples, rows }
}

/** A row is set aside, or taken back. */
export const withOn = (examples: Examples, at: number, on: boolean): Examples =>
  withValue(examples, at, place.on, on ? 1 : 0)

/** Several rows are set aside or taken back in one step. */
export const withAllOn = (examples: Examples, rows: readonly number[], on: boolean): Examples =>
  rows.reduce((table, at) => withOn(table, at, on), examples)

/** Another wish: what an output should be in this row, in percent, cut to ±100. */
export function withWish(examples: Examples, at: number, output: string, wish: number): Examples {
  const column = examples.outputs.indexOf(output)
  if (column < 0 || !Number.isFinite(wish)) return examples
  const cut = Math.max(-100, Math.min(100, Math.round(wish * 100) / 100)) + 0
  return withValue(examples, at, headOfRow + examples.inputs.length + column, cut)
}

/** Without the last row that is on; of a drive all of it. Undefined: nothing is left. */
export function withoutLast(examples: Examples): Examples | undefined {
  const last = examples.rows.at(-1)
  if (!last) return undefined
  const drive = last[place.drive]!
  const rows = examples.rows.filter((row) => row[place.drive] !== drive)
  return withoutDrive({ ...examples, rows }, drive)
}

/** Rows that are written in the last so many ticks of the drive that was recorded last. */
export function lastTicks({ rows }: Examples, ticks: number): readonly number[] {
  const last = rows.at(-1)
  if (!last) return []
  const from = last[place.tick]! - ticks
  return rows.flatMap((row, at) =>
    row[place.drive] === last[place.drive] && row[place.tick]! > from ? [at] : [],
  )
}

/** Without these rows: they are thrown away, and undo brings them back. */
export function withoutRows(examples: Examples, rows: readonly number[]): Examples {
  const gone = new Set(rows)
  return { ...examples, rows: examples.rows.filter((_, at) => !gone.has(at)) }
}

function withoutDrive(examples: Examples, drive: number): Examples {
  const rows = examples.rows.map((row) =>
    row[place.drive]! > drive ? [row[place.drive]! - 1, ...row.slice(1)] : row,
  )
  return { ...examples, rows, drives: examples.drives.filter((_, at) => at !== drive) }
}

/** A drive is the test, is not, or is left to chance (null). */
export function withTest(examples: Examples, drive: string, test: boolean | null): Examples {
  const drives = examples.drives.map((one) => {
    if (one.id !== drive) return one
    const { test: _, ...rest } = one
    return test === null ? rest : { ...rest, test }
  })
  return { ...examples, drives }
}

/** Where a row's wishes go. */
export const turns = ['straight', 'left', 'right', 'back', 'stand'] as const
export type Turn = (typeof turns)[number]

/** Percent below which a wheel stands, and by which wheels differ in a turn. */
const still = 5

export function turnOf(left: number, right: number): Turn {
  if (Math.max(Math.abs(left), Math.abs(right)) < still) return 'stand'
  if (Math.abs(right - left) > 2 * still) return right > left ? 'left' : 'right'
  return left + right < 0 ? 'back' : 'straight'
}
