import type { Pair } from '../train/rows.ts'
import { headOfRow, mostOf, place, type Drive, type Examples, type Row } from './types.ts'

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
  /** In percent, in the order of the columns. */
  readonly inputs: readonly number[]
  readonly outputs: readonly number[]
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

const isRepeat = (a: Recorded, b: Recorded) =>
  a.inputs.every((value, k) => Math.abs(value - b.inputs[k]!) <= 1) &&
  a.outputs.every((value, k) => Math.abs(value - b.outputs[k]!) <= 1)

/** Two decimals; −0 is 0. */
const rounded = (value: number) => Math.round(100 * value) / 100 + 0

const rowOf = ({ tick, pose, inputs, outputs }: Recorded, drive: number): Row => [
  ...[drive, tick, rounded(pose.x), rounded(pose.y), rounded(pose.heading), 1],
  ...[...inputs, ...outputs].map(rounded),
]
