import type { Brain, Neuron, Weights } from './types.ts'

/** A network without neurons. */
export const emptyBrain: Brain = { kind: 'network', layers: [[], []], weights: {}, sets: {} }

/**
 * The same brain for other neurons: layers become what the blocks say, weights stay where they are written
 * (running.md 11). Neurons that are already known keep their bias and activation.
 */
export function follow(brain: Brain, ...layers: readonly (readonly string[])[]): Brain {
  const known = new Map(brain.layers.flat().map((neuron) => [neuron.id, neuron]))
  const next = layers.map((ids) => ids.map((id) => known.get(id) ?? newNeuron(id)))
  return sameLayers(brain.layers, next) ? brain : { ...brain, layers: next }
}

const newNeuron = (id: string): Neuron => ({ id, activation: 'identity', bias: 0 })

const sameLayers = (a: Brain['layers'], b: Brain['layers']) =>
  a.length === b.length &&
  a.every((layer, l) => layer.length === b[l]!.length && layer.every((neuron, n) => neuron === b[l]![n]))

/** The same brain with one weight changed. */
export const withWeight = (brain: Brain, from: string, to: string, weight: number): Brain => ({
  ...brain,
  weights: { ...brain.weights, [from]: { ...brain.weights[from], [to]: weight } },
})

/** The same brain with every weight 0. */
export const withoutWeights = (brain: Brain): Brain => ({ ...brain, weights: {} })

/** Duplicated neurons get the weights of their originals, in and out (running.md 11). */
export function copyWeights(
  brain: Brain,
  pairs: readonly { readonly from: string; readonly to: string }[],
): Brain {
  const copyOf = new Map(pairs.map(({ from, to }) => [from, to]))
  const weights: { [from: string]: { [to: string]: number } } = {}
  for (const [from, row] of Object.entries(brain.weights)) {
    const grown = { ...row }
    for (const [to, weight] of Object.entries(row)) {
      const copy = copyOf.get(to)
      if (copy !== undefined) grown[copy] = weight
    }
    weights[from] = grown
  }
  for (const [original, copy] of copyOf) if (weights[original]) weights[copy] = { ...weights[original] }
  return { ...brain, weights }
}

/** Weights of the links that exist, nothing else: what is written into a file. */
export function pruneWeights(brain: Brain): Weights {
  const pruned: { [from: string]: { [to: string]: number } } = {}
  brain.layers.slice(1).forEach((layer, index) => {
    for (const from of brain.layers[index] ?? [])
      for (const to of layer) {
        const weight = brain.weights[from.id]?.[to.id]
        if (weight) (pruned[from.id] ??= {})[to.id] = weight
      }
  })
  return pruned
}
