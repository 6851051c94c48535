import { draw, type StreamState } from '@botgarten/numbers'
import { weightOf } from '../network.ts'
import type { Brain, Weights } from '../types.ts'
import { eachParameter, layOutTraining, weightsIn } from './layout.ts'
import type { Layer, TrainNet } from './types.ts'

export interface Beginning {
  readonly weights: Weights
  /** Were all links 0 and had to be drawn, since else every hidden neuron would learn the same? */
  readonly shaken: boolean
}

/**
 * Weights to begin practice with. `zero`: 0 without a hidden layer, else drawn; biases 0. `knobs`: as they stand; where a
 * network with hidden neurons has only links of 0, half of a draw.
 * @param stream of its own: `stream(seed, 'learn/start/…')`
 */
export function beginningOf(
  layers: Brain['layers'],
  weights: Weights,
  from: 'knobs' | 'zero',
  stream: StreamState,
): Beginning {
  const net = layOutTraining(layers)
  if (from === 'zero')
    return { weights: drawn(net, weights, net.layers.length > 1 ? 1 : 0, stream), shaken: false }
  const shaken = net.layers.length > 1 && !hasLinks(net, weights)
  return { weights: shaken ? drawn(net, weights, 0.5, stream, true) : weights, shaken }
}

function hasLinks(net: TrainNet, weights: Weights): boolean {
  let found = false
  eachParameter(net, (_, from, to) => {
    if (from !== null && weightOf(weights, from, to) !== 0) found = true
  })
  return found
}

/** Uniform in ± the limit of each layer, times `scale`; biases stay or are 0. Links that are not there stay written. */
function drawn(
  net: TrainNet,
  weights: Weights,
  scale: number,
  stream: StreamState,
  keepsBias = false,
): Weights {
  const parameters = new Float64Array(net.parameters)
  net.layers.forEach((layer, index) => {
    const limit = scale * limitOf(layer, net.neurons[index + 1]!)
    for (let k = layer.weights; k < layer.biases; k++)
      parameters[k] = limit === 0 ? 0 : (2 * draw(stream) - 1) * limit
  })
  const begun = weightsIn(net, parameters, weights)
  return keepsBias && weights['#bias'] ? { ...begun, '#bias': weights['#bias'] } : begun
}

/** He et al. 2015 for ReLU, else Glorot & Bengio 2010, eq. 16. */
function limitOf({ inputs, outputs }: Layer, neurons: Brain['layers'][number]): number {
  const isRelu = neurons.every(({ activation }) => activation === 'relu')
  return Math.sqrt(6 / (isRelu ? inputs : inputs + outputs))
}
