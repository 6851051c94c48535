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

/** Weights under a name: '' are those on the knobs. A set that is not there yet begins as they are. */
export const weightsOf = (brain: Brain, set: string): Weights =>
  (set !== '' && brain.sets[set]) || brain.weights

/** The same brain with other weights under a name, '' for those on the knobs. */
export const withWeights = (brain: Brain, weights: Weights, set = ''): Brain =>
  set === '' ? { ...brain, weights } : { ...brain, sets: { ...brain.sets, [set]: weights } }

/** The same brain with one weight changed, on the knobs or in a named set. */
export function withWeight(brain: Brain, from: string, to: string, weight: number, set = ''): Brain {
  const weights = weightsOf(brain, set)
  return withWeights(brain, { ...weights, [from]: { ...weights[from], [to]: weight } }, set)
}

/** The same brain with every weight 0, on the knobs or in a named set. */
export const withoutWeights = (brain: Brain, set = ''): Brain => withWeights(brain, {}, set)

/** Duplicated neurons get the weights of their originals, in and out (running.md 11), in every set. */
export function copyWeights(
  brain: Brain,
  pairs: readonly { readonly from: string; readonly to: string }[],
): Brain {
  const copyOf = new Map(pairs.map(({ from, to }) => [from, to]))
  const sets = Object.entries(brain.sets).map(([name, weights]) => [name, copied(weights, copyOf)])
  return {
    ...brain,
    weights: copied(brain.weights, copyOf),
    sets: Object.fromEntries(sets) as Brain['sets'],
  }
}

function copied(all: Weights, copyOf: ReadonlyMap<string, string>): Weights {
  const weights: { [from: string]: { [to: string]: number } } = {}
  for (const [from, row] of Object.entries(all)) {
    const grown = { ...row }
    for (const [to, weight] of Object.entries(row)) {
      const copy = copyOf.get(to)
      if (copy !== undefined) grown[copy] = weight
    }
    weights[from] = grown
  }
  for (const [original, copy] of copyOf) if (weights[original]) weights[copy] = { ...weights[original] }
  return weights
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
