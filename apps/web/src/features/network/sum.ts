import type { NetView } from '@botgarten/lab'
import type { Weights } from '@botgarten/learning/neural-network'
import type { Neuron } from '#figures/network/neurons.ts'

/** What makes up the sum of a neuron: value × weight of every link into it, and its bias. */
export interface Sum {
  /** The neuron's label. */
  readonly output: string
  readonly colour: string
  readonly terms: readonly {
    readonly id: string
    readonly colour: string
    /** null: nothing has run yet, here and below. */
    readonly input: number | null
    readonly weight: number
  }[]
  /** Added to the terms; 0 is not shown. */
  readonly bias: number
  readonly sum: number | null
  /** It has not run so: the sum is what would be. */
  readonly would: boolean
}

/** `before`: the layer whose links lead to the neuron. `weights`: those that the view was computed with. */
export function sumOf(
  neuron: Neuron,
  before: readonly Neuron[],
  view: NetView | null,
  weights: Weights,
): Sum {
  const { id, label, colour } = neuron
  const terms = before.map((input) => ({
    id: input.id,
    colour: input.colour,
    input: view?.outputs[input.id] ?? null,
    weight: weights[input.id]?.[id] ?? 0,
  }))
  return {
    output: label,
    colour,
    terms,
    bias: view?.biases[id] ?? 0,
    sum: view?.sums[id] ?? null,
    would: view?.ran === false,
  }
}
