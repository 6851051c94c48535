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

/** How the numbers of a sum are rounded. */
export interface Rounding {
  /** Digits behind the comma of inputs and of the sum. */
  readonly digits: 0 | 1
  /** Does the sum of the rounded numbers give the rounded sum? */
  readonly isExact: boolean
}

/** Digits behind the comma of weights and biases. */
const weightDigits = 2
const rounded = (value: number, digits: number) => Number(value.toFixed(digits))
const isWhole = (value: number) => Math.abs(value - Math.round(value)) < 0.005

/**
 * Whole numbers where all of them are whole, else one digit behind the comma, so that the shown numbers add up.
 * @param coarse numbers without digits behind the comma, for children who have not met them
 */
export function roundingOf({ terms, bias, sum }: Omit<Sum, 'output' | 'colour'>, coarse: boolean): Rounding {
  const values = [sum, ...terms.map(({ input }) => input)].map((value) => value ?? 0)
  const digits = coarse || values.every(isWhole) ? 0 : 1
  const total = terms.reduce(
    (before, { input, weight }) => before + rounded(input ?? 0, digits) * rounded(weight, weightDigits),
    rounded(bias, weightDigits),
  )
  // A sum exactly between two numbers may be rounded to either.
  const isExact = Math.abs(total - rounded(sum ?? 0, digits)) <= 0.5 / 10 ** digits + 1e-9
  return { digits, isExact }
}
