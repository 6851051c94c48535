import type { Pair } from '../train/rows.ts'
import { columnsFor } from './columns.ts'
import { headOfRow, mostOf, place, type Drive, type Examples, type Row, type ShownBy } from './types.ts'

/** No examples yet, for a network with these neurons. */
export const noExamples = (inputs: readonly string[], outputs: readonly string[]): Examples => ({
  ...{ version: 1, inputs, outputs, drives: [], rows: [] },
})

/** An example that practises, with its place in the table. */
export interface ShownPair extends Pair {
  readonly row: number
  readonly drive: number
}

/** The examples that practise: those that are on and have no gap in the columns of these neurons. */
export function shownPairs(
  { inputs: ins, outputs: outs, rows }: Examples,
  inputs: readonly string[],
  outputs: readonly string[],
): { readonly pairs: readonly ShownPair[]; readonly gaps: number } {
  const at = (id: string, columns: readonly string[], before: number) => {
    const column = columns.indexOf(id)
    return column < 0 ? -1 : before + column
  }
  const ofInputs = inputs.map((id) => at(id, ins, headOfRow))
  const ofOutputs = outputs.map((id) => at(id, outs, headOfRow + ins.length))
  const on = rows.map((values, row) => ({ values, row })).filter(({ values }) => values[place.on] === 1)
  const pairs = on.flatMap(({ values, row }): ShownPair[] => {
    const [read, wished] = [ofInputs, ofOutputs].map((columns) =>
      columns.map((column) => values[column] ?? null),
    )
    if (!isWhole(read!) || !isWhole(wished!)) return []
    return [{ row, drive: values[place.drive]!, inputs: read, outputs: wished }]
  })
  return { pairs, gaps: on.length - pairs.length }
}

const isWhole = (values: readonly (number | null)[]): values is number[] => !values.includes(null)

/** What a recording adds: the same table with a drive's rows behind the others. */
export interface Recorded {
  readonly tick: number
  /** cm, degrees. */
  readonly pose: { readonly x: number; readonly y: number; readonly heading: number }
  /** In percent, in the order of the columns; null where nothing belongs there. */
  readonly inputs: readonly (number | null)[]
  readonly outputs: readonly (number | null)[]
}

/**
 * The table with one drive more. A row that is equal to the one before it within 1 in every column is not written again. What
 * goes beyond the limits is left out and counted; `left` −1: there may be no more drives.
 */
export function withDrive(
  examples: Examples,
  drive: Drive,
  recorded: readonly Recorded[],
): { readonly examples: Examples; readonly left: number } {
  const index = examples.drives.length
  if (index >= mostOf.drives) return { examples, left: -1 }
  const rows = withoutRepeats(recorded).map((one) => rowOf(one, index))
  const room = mostOf.rows - examples.rows.length
  return {
    examples: {
      ...examples,
      drives: [...examples.drives, drive],
      rows: [...examples.rows, ...rows.slice(0, room)],
    },
    left: Math.max(0, rows.length - room),
  }
}

function withoutRepeats(recorded: readonly Recorded[]): readonly Recorded[] {
  const kept: Recorded[] = []
  for (const one of recorded) {
    const before = kept.at(-1)
    if (!before || !isRepeat(before, one)) kept.push(one)
  }
  return kept
}

const isRepeat = (a: Recorded, b: Recorded) => isNear(a.inputs, b.inputs) && isNear(a.outputs, b.outputs)

type Values = readonly (number | null)[]

const isNear = (a: Values, b: Values) =>
  a.every((value, k) => {
    const other = b[k] ?? null
    return value === null || other === null ? value === other : Math.abs(value - other) <= 1
  })

/** Two decimals; −0 is 0. */
const rounded = (value: number) => Math.round(100 * value) / 100 + 0

const rowOf = ({ tick, pose, inputs, outputs }: Recorded, drive: number): Row => [
  ...[drive, tick, rounded(pose.x), rounded(pose.y), rounded(pose.heading), 1],
  ...[...inputs, ...outputs].map((value) => (value === null ? null : rounded(value))),
]

/** An example as a network gives it: by the ids of its neurons, in percent. */
export interface Shown extends Pick<Recorded, 'tick' | 'pose'> {
  readonly inputs: { readonly [neuronId: string]: number }
  readonly outputs: { readonly [neuronId: string]: number }
}

/**
 * The table with one row more, at the end of a drive; the drive begins with its first row. Neurons that have no column get one.
 * The same table where the row repeats the one before, within 1 in every column, or where there is no room.
 */
export function withRow(examples: Examples, drive: Drive, shown: Shown): Examples {
  if (!hasRoom(examples, drive.id)) return examples
  const table = columnsFor(examples, Object.keys(shown.inputs), Object.keys(shown.outputs))
  const known = table.drives.findIndex(({ id }) => id === drive.id)
  const index = known < 0 ? table.drives.length : known
  const row = rowOf(inColumns(table, shown), index)
  const last = table.rows.at(-1)
  if (last?.[place.drive] === index && isNear(last.slice(headOfRow), row.slice(headOfRow))) return examples
  const drives = known < 0 ? [...table.drives, drive] : table.drives
  return { ...table, drives, rows: [...table.rows, row] }
}

const inColumns = ({ inputs, outputs }: Examples, shown: Shown): Recorded => ({
  ...{ tick: shown.tick, pose: shown.pose },
  inputs: inputs.map((id) => shown.inputs[id] ?? null),
  outputs: outputs.map((id) => shown.outputs[id] ?? null),
})

/** May one more row be written into this drive? */
export const hasRoom = ({ drives, rows }: Examples, drive: string): boolean =>
  rows.length < mostOf.rows && (drives.length < mostOf.drives || drives.some(({ id }) => id === drive))

/** A name that no drive of the table has: what shows, and a number. */
export function freshDrive({ drives }: Examples, by: ShownBy): string {
  const taken = new Set(drives.map(({ id }) => id))
  let number = drives.length + 1
  while (taken.has(`${by}-${number}`)) number++
  return `${by}-${number}`
}
