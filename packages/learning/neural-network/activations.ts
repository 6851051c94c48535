import type { Activation, Neuron } from './types.ts'

/** Activations that need a power of e: `curves.ts` has them, for who needs them. */
export interface Curves {
  readonly sigmoid: (sum: number) => number
  readonly tanh: (sum: number) => number
  /** Makes the outputs of a layer's neurons with softmax out of their sums, in place. */
  readonly softmax: (neurons: readonly Neuron[], sums: number[]) => void
}

type Alone = { [name in Exclude<Activation, 'softmax'>]?: (sum: number) => number }

/** Each works on sum ÷ 100 and gives × 100: 100 is the full ring. */
const alone: Alone = {
  identity: (sum) => sum,
  relu: (sum) => (sum > 0 ? sum : 0),
  threshold: (sum) => (sum > 0 ? 100 : 0),
}
let softmax: Curves['softmax'] | undefined

/** Brings the other activations. @see curves.ts */
export function knowCurves(curves: Curves): void {
  Object.assign(alone, { sigmoid: curves.sigmoid, tanh: curves.tanh })
  softmax = curves.softmax
}

/** A layer's sums become its outputs, in place. @throws TypeError for an activation that is not loaded. */
export function activate(neurons: readonly Neuron[], sums: number[]): void {
  let shared = false
  for (let k = 0; k < neurons.length; k++) {
    const { activation } = neurons[k]!
    if (activation === 'softmax') shared = true
    else sums[k] = alone[activation]!(sums[k]!)
  }
  if (shared) softmax!(neurons, sums)
}
