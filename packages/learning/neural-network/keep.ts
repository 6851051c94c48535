import { biasRow } from './network.ts'
import type { Activation, Brain, Neuron, Weights } from './types.ts'

// What only deeper networks and files of brains need.

/** The same brain with another activation for one output; softmax is for all outputs, or for none. */
export function withActivation(brain: Brain, id: string, activation: Activation): Brain {
  const last = brain.layers.length - 1
  const outputs = brain.layers[last] ?? []
  const shares = outputs.some((neuron) => neuron.activation === 'softmax')
  const all = activation === 'softmax'
  const changed = outputs.map((neuron) => {
    if (all || neuron.id === id) return { ...neuron, activation }
    return shares ? { ...neuron, activation: 'identity' as const } : neuron
  })
  return { ...brain, layers: brain.layers.with(last, changed) }
}

/** Weights of the links that exist and biases of neurons that are there, nothing else: what is written into a file. */
export function pruneWeights({ layers }: Brain, weights: Weights): Weights {
  const pruned: { [from: string]: { [to: string]: number } } = {}
  const keep = (from: string, to: Neuron, unless: number) => {
    const weight = weights[from]?.[to.id] ?? unless
    if (weight !== unless) (pruned[from] ??= {})[to.id] = weight
  }
  layers.slice(1).forEach((layer, index) => {
    for (const to of layer) {
      for (const from of layers[index] ?? []) keep(from.id, to, 0)
      keep(biasRow, to, to.bias)
    }
  })
  return pruned
}
