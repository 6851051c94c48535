import type { Activation } from '@botgarten/learning/neural-network/brain'
import type { Block } from '../types.ts'
import { field } from './fields.ts'
import { plugged } from './rows.ts'

/** A hidden layer's block stands in the network's socket for inputs, and what comes before it in its own. */
export const hiddenType = 'ai_nn_hidden_layer'

/** How many neurons a hidden layer may have, and how many all layers together. */
export const mostInLayer = 64
export const mostNeurons = 256

export interface HiddenLayer {
  readonly id: string
  readonly neurons: number
  readonly activation: Activation
}

/** In the words of files. */
const activations: ReadonlyMap<string, Activation> = new Map([
  ['RELU', 'relu'],
  ['SIGMOID', 'sigmoid'],
  ['TANH', 'tanh'],
  ['THRESHOLD', 'threshold'],
  ['LINEAR', 'identity'],
])

/** The blocks of a network's hidden layers, from the outputs to the inputs, and the list of inputs at the end. */
function chainOf(network: Block): { readonly hidden: readonly Block[]; readonly list: Block | undefined } {
  const hidden: Block[] = []
  let next = plugged(network, 'INPUT_LAYER')
  while (next?.type === hiddenType) {
    hidden.push(next)
    next = plugged(next, 'LAYER')
  }
  return { hidden, list: next }
}

/** The list of a network's inputs, however many hidden layers stand before it. */
export const inputListOf = (network: Block): Block | undefined => chainOf(network).list

/** A network's hidden layers from the inputs to the outputs. */
export const hiddenIn = (network: Block): HiddenLayer[] => chainOf(network).hidden.map(layerOf).reverse()

/** How many neurons a hidden layer's block wants. */
export const wantedNeurons = (block: Block): number => Math.round(Number(field(block, 'NEURONS', '3'))) || 1

function layerOf(block: Block): HiddenLayer {
  const neurons = Math.min(Math.max(wantedNeurons(block), 1), mostInLayer)
  return { id: block.id, neurons, activation: activations.get(field(block, 'ACTIVATION', 'RELU')) ?? 'relu' }
}
