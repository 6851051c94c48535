import { biasOf, biasRow, weightOf } from '../network.ts'
import { activations, type Brain, type Weights } from '../types.ts'
import type { Layer, TrainNet } from './types.ts'

/** A network laid out for practice: layer by layer its weights, then its biases. */
export function layOutTraining(neurons: Brain['layers']): TrainNet {
  const layers: Layer[] = []
  let [from, parameters] = [0, 0]
  neurons.slice(1).forEach((layer, index) => {
    const [inputs, outputs] = [neurons[index]!.length, layer.length]
    const to = from + inputs
    const biases = parameters + inputs * outputs
    const last = index === neurons.length - 2
    layers.push({ inputs, outputs, from, to, weights: parameters, biases, last })
    from = to
    parameters = biases + outputs
  })
  const all = neurons.flat()
  const codes = Uint8Array.from(all, ({ activation }) => activations.indexOf(activation))
  return { neurons, layers, count: all.length, parameters, activations: codes, shares: sharesIn(neurons) }
}

/** Do all outputs share 100? */
export function sharesIn(neurons: Brain['layers']): boolean {
  const outputs = neurons.at(-1) ?? []
  return outputs.length > 0 && outputs.every(({ activation }) => activation === 'softmax')
}

/** Calls `visit` for every parameter: of a bias `from` is null. */
export function eachParameter(
  { neurons, layers }: TrainNet,
  visit: (at: number, from: string | null, to: string) => void,
): void {
  layers.forEach(({ inputs, weights, biases }, index) => {
    neurons[index + 1]!.forEach(({ id: to }, j) => {
      neurons[index]!.forEach(({ id: from }, i) => visit(weights + j * inputs + i, from, to))
      visit(biases + j, null, to)
    })
  })
}

/** The parameters of weights as on the knobs; a bias there counts in percent. */
export function parametersIn(net: TrainNet, weights: Weights): Float64Array {
  const parameters = new Float64Array(net.parameters)
  const neurons = new Map(net.neurons.flat().map((neuron) => [neuron.id, neuron]))
  eachParameter(net, (at, from, to) => {
    parameters[at] = from === null ? biasOf(weights, neurons.get(to)!) / 100 : weightOf(weights, from, to)
  })
  return parameters
}

/** Parameters as weights; what the other weights say of links that are not there stays. */
export function weightsIn(net: TrainNet, parameters: Float64Array, others: Weights = {}): Weights {
  const weights: { [from: string]: { [to: string]: number } } = {}
  for (const [from, row] of Object.entries(others)) weights[from] = { ...row }
  eachParameter(net, (at, from, to) => {
    const value = parameters[at]!
    if (from === null && value === 0 && weights[biasRow]?.[to] === undefined) return
    ;(weights[from ?? biasRow] ??= {})[to] = from === null ? 100 * value : value
  })
  return weights
}
