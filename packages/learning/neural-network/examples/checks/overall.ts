import { farApart, type ExampleFinding, type Table } from './types.ts'

// What is said of the whole table rather than of one example.

/** So many turns to one side for one to the other. */
const oneSide = 3
/** Percent by which the wheels differ in a turn. */
const turns = 5
/** Percent: readings farther than this from every example were never seen. */
const unseen = 25
/** Percent: a column that spreads less is all alike. */
const alike = 5

/** Turns to one side far more often than to the other; a mirror makes up for it. */
export function oneSided({ pairs, wheels, mirror }: Table): readonly ExampleFinding[] {
  if (!wheels || mirror) return []
  const differences = pairs.map(({ outputs }) => outputs[wheels.right]! - outputs[wheels.left]!)
  const left = differences.filter((difference) => difference > turns).length
  const right = differences.filter((difference) => difference < -turns).length
  return Math.max(left, right) > oneSide * Math.max(1, Math.min(left, right))
    ? [{ kind: 'oneSided', left, right }]
    : []
}

/** Where the last drive failed and no example is near. */
export const neverSeen = ({ pairs, failed = [] }: Table): readonly ExampleFinding[] =>
  failed
    .filter((readings) => !pairs.some(({ inputs }) => farApart(inputs, readings) <= unseen))
    .map((readings) => ({ kind: 'neverSeen', readings }))

/** Columns from which nothing can be learned, or in which nothing is to be learned. */
export function allAlike({ pairs, inputs, outputs }: Table): readonly ExampleFinding[] {
  if (pairs.length < 2) return []
  const find = (ids: readonly string[], isInput: boolean) =>
    ids.flatMap((column, k): ExampleFinding[] => {
      const values = pairs.map((pair) => (isInput ? pair.inputs : pair.outputs)[k]!)
      const [least, most] = values.reduce(
        ([a, b], value) => [Math.min(a, value), Math.max(b, value)],
        [Infinity, -Infinity],
      )
      if (most - least >= alike) return []
      return [{ kind: 'allAlike', column, isInput, value: (least + most) / 2 }]
    })
  return [...find(inputs, true), ...find(outputs, false)]
}

/** More than half of the examples say: do nothing. */
export function sleeping({ pairs }: Table): readonly ExampleFinding[] {
  const rows = pairs.filter(({ outputs }) => outputs.every((value) => value === 0)).map(({ row }) => row)
  return rows.length > pairs.length / 2 ? [{ kind: 'sleeping', rows }] : []
}

/** Fewer examples, mirror images counted, than two for every knob. */
export function few({ pairs, mirror, knobs }: Table): readonly ExampleFinding[] {
  const rows = pairs.length
  const isMirrored = Boolean(mirror)
  return (isMirrored ? 2 * rows : rows) < 2 * knobs ? [{ kind: 'few', rows, isMirrored, knobs }] : []
}
