import { forward, layOut, type Brain, type Weights } from '@botgarten/learning/neural-network'

/** Values of a network's neurons at a moment. */
type Values = { readonly [id: string]: number }

/** A neuron's value, with some neurons of an earlier layer set to others. */
export type Answer = (set: Values) => number

/**
 * The value of a neuron as a function of those in the layer of `from`: what is not set stays as it is at this moment. null where
 * `from` does not lie before `to`.
 */
export function answerOf(
  brain: Brain,
  weights: Weights,
  now: Values,
  from: string,
  to: string,
): Answer | null {
  const layerOf = (id: string) => brain.layers.findIndex((layer) => layer.some((one) => one.id === id))
  const [first, last] = [layerOf(from), layerOf(to)]
  if (first < 0 || last <= first) return null
  const ids = brain.layers[first]!.map(({ id }) => id)
  const index = brain.layers[last]!.findIndex(({ id }) => id === to)
  const net = layOut({ ...brain, layers: brain.layers.slice(first, last + 1) }, weights)
  const inputs = ids.map(() => 0)
  return (set) => {
    ids.forEach((id, k) => (inputs[k] = set[id] ?? now[id] ?? 0))
    return forward(net, inputs)[index] ?? 0
  }
}

/** The layers from which a neuron can be asked about; none for an input. */
export const layersBefore = ({ layers }: Brain, id: string): Brain['layers'] =>
  layers.slice(
    0,
    Math.max(
      0,
      layers.findIndex((layer) => layer.some((one) => one.id === id)),
    ),
  )

export interface Range {
  readonly least: number
  readonly most: number
}

/** What a neuron can say: sensors 0 to 100, others as far either way as they say now. */
export const rangeOf = (value: number, isInput: boolean): Range => {
  if (isInput) return { least: 0, most: Math.max(100, Math.ceil(value / 50) * 50) }
  const far = Math.max(100, Math.ceil(Math.abs(value) / 50) * 50)
  return { least: -far, most: far }
}

/** A range in steps of 50 that holds 0 to 100 and all these values. */
export const rangeAround = (values: readonly number[]): Range => ({
  least: Math.floor(Math.min(0, ...values) / 50) * 50,
  most: Math.ceil(Math.max(100, ...values) / 50) * 50,
})

/** So many numbers evenly over a range, both ends included. */
export const spread = ({ least, most }: Range, count: number): readonly number[] =>
  Array.from({ length: count }, (_, index) => least + ((most - least) * index) / (count - 1))

/** Lowest and highest value of a function of two inputs, on a grid of 5 by 5 points over their ranges. */
export function endsOf(answer: (x: number, y: number) => number, [x, y]: readonly [Range, Range]): Range {
  const values = spread(x, 5).flatMap((one) => spread(y, 5).map((two) => answer(one, two)))
  return { least: Math.min(...values), most: Math.max(...values) }
}

/** How a curve goes: one word for all of it. */
export function courseOf(values: readonly number[]): 'rises' | 'falls' | 'stays' | 'bends' {
  const steps = values.slice(1).map((value, index) => value - values[index]!)
  const up = steps.some((step) => step > 1e-9)
  const down = steps.some((step) => step < -1e-9)
  if (up && down) return 'bends'
  return up ? 'rises' : down ? 'falls' : 'stays'
}
