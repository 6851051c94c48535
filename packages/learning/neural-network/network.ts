import { activate } from './activations.ts'
import type { Brain, Neuron, NetTrace, Term, Weights } from './types.ts'

/** Row of a weight table that holds biases: a bias is the weight of a link from what is always 1. */
export const biasRow = '#bias'

/** A brain laid out for running: `weights[layer][to][from]`, one row a neuron of the layer after the inputs. */
export interface Net {
  readonly inputs: number
  readonly layers: readonly {
    readonly neurons: readonly Neuron[]
    readonly weights: readonly Float64Array[]
    readonly biases: Float64Array
    /** Where the layer writes its outputs; used again in every run. */
    readonly out: number[]
  }[]
}

/** The weight of a link, 0 where none is written. */
export const weightOf = (weights: Weights, from: string, to: string): number => weights[from]?.[to] ?? 0

/** The bias of a neuron: as the weights say, else its own. */
export const biasOf = (weights: Weights, { id, bias }: Pick<Neuron, 'id' | 'bias'>): number =>
  weights[biasRow]?.[id] ?? bias

/** Lays a brain out for running. `weights` stands in for the brain's own, for example one of its named sets. */
export function layOut(brain: Brain, weights: Weights = brain.weights): Net {
  const layers = brain.layers.slice(1).map((neurons, index) => {
    const before = brain.layers[index] ?? []
    const row = (to: Neuron) => Float64Array.from(before, (from) => weightOf(weights, from.id, to.id))
    const biases = Float64Array.from(neurons, (neuron) => biasOf(weights, neuron))
    return { neurons, weights: neurons.map(row), biases, out: neurons.map(() => 0) }
  })
  return { inputs: brain.layers[0]?.length ?? 0, layers }
}

/**
 * One run of the network: out = f(Σ in·w + b), layer by layer (Goodfellow, Bengio, Courville 2016, eq. 6.1 ff.).
 * Inputs beyond the first layer's width are ignored, missing ones count 0. The returned array is used again by the next run.
 */
export function forward(net: Net, inputs: readonly number[]): readonly number[] {
  let values = inputs
  for (const { neurons, weights, biases, out } of net.layers) {
    for (let to = 0; to < neurons.length; to++) out[to] = biases[to]! + weightedSum(weights[to]!, values)
    activate(neurons, out)
    values = out
  }
  return values
}

function weightedSum(weights: Float64Array, values: readonly number[]): number {
  let sum = 0
  for (let from = 0; from < weights.length; from++) sum += (values[from] ?? 0) * weights[from]!
  return sum
}

/** The same run, opened: every product, every bias, every sum, every output. */
export function trace(brain: Brain, inputs: readonly number[], weights: Weights = brain.weights): NetTrace {
  const terms: Term[] = []
  const biases: { [id: string]: number } = {}
  const sums: { [id: string]: number } = {}
  const outputs: { [id: string]: number } = {}
  brain.layers[0]?.forEach((neuron, index) => (outputs[neuron.id] = inputs[index] ?? 0))
  brain.layers.slice(1).forEach((layer, index) => {
    const before = brain.layers[index] ?? []
    for (const to of layer) {
      const into = before.map((from) =>
        term(from.id, to.id, outputs[from.id] ?? 0, weightOf(weights, from.id, to.id)),
      )
      terms.push(...into)
      biases[to.id] = biasOf(weights, to)
      sums[to.id] = biases[to.id]! + into.reduce((sum, { product }) => sum + product, 0)
    }
    const values = layer.map(({ id }) => sums[id]!)
    activate(layer, values)
    layer.forEach(({ id }, k) => (outputs[id] = values[k]!))
  })
  return { terms, biases, sums, outputs }
}

const term = (from: string, to: string, input: number, weight: number): Term => ({
  from,
  to,
  input,
  weight,
  product: input * weight,
})
