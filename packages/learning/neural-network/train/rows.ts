import type { Rows } from './types.ts'

/** One example in percent, as it is shown. */
export interface Pair {
  readonly inputs: readonly number[]
  readonly outputs: readonly number[]
}

/** Which neuron stands in for which in a mirror; an index stands for itself where it has no side. */
export interface Mirror {
  readonly inputs: readonly number[]
  readonly outputs: readonly number[]
}

/** The same example seen in a mirror. Twice is the example itself. */
export const mirrored = ({ inputs, outputs }: Pair, mirror: Mirror): Pair => ({
  inputs: mirror.inputs.map((at) => inputs[at]!),
  outputs: mirror.outputs.map((at) => outputs[at]!),
})

/**
 * Examples laid out for practice. With a mirror each is followed by its mirror image. `shares`: for outputs that
 * share 100 a target is 1 where it was shown, else 0.
 */
export function rowsOf(
  pairs: readonly Pair[],
  { mirror = null, shares = false }: { readonly mirror?: Mirror | null; readonly shares?: boolean } = {},
): Rows {
  const all = mirror ? pairs.flatMap((pair) => [pair, mirrored(pair, mirror)]) : pairs
  const target = shares ? (value: number) => (value > 0 ? 1 : 0) : (value: number) => value / 100
  return {
    count: all.length,
    inputs: Float64Array.from(all.flatMap(({ inputs }) => inputs.map((value) => value / 100))),
    targets: Float64Array.from(all.flatMap(({ outputs }) => outputs.map(target))),
  }
}
