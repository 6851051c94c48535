import type { Activation, Brain, Neuron, Weights } from './types.ts'

/** A network without neurons. */
export const emptyBrain: Brain = { kind: 'network', layers: [[], []], weights: {}, sets: {} }

/** The name of the k-th neuron, k from 1, of a hidden layer's block (running.md 11). */
export const hiddenId = (block: string, k: number): string => `${block}#${k}`

/** A neuron as a block says it: by its id alone, or with the activation that the block chooses. */
type Said = string | { readonly id: string; readonly activation: Activation }

/**
 * The same brain for other neurons: layers become what the blocks say, weights stay where they are written
 * (running.md 11). Neurons that are already known keep their bias, and their activation where the block says none.
 */
export function follow(brain: Brain, ...layers: readonly (readonly Said[])[]): Brain {
  const known = new Map(brain.layers.flat().map((neuron) => [neuron.id, neuron]))
  const next = layers.map((said, layer) => {
    const fresh = usualIn(layer === layers.length - 1 ? brain.layers.at(-1) : undefined)
    return said.map((one) => neuronFor(one, known, fresh))
  })
  return sameLayers(brain.layers, next) ? brain : { ...brain, layers: next }
}

function neuronFor(said: Said, known: ReadonlyMap<string, Neuron>, fresh: Activation): Neuron {
  const { id, activation } = typeof said === 'string' ? { id: said, activation: undefined } : said
  const before = known.get(id)
  if (before && (activation === undefined || activation === before.activation)) return before
  return { id, activation: activation ?? fresh, bias: before?.bias ?? 0 }
}

/** One more of those who share 100 shares with them; every other new neuron gives its sum. */
const usualIn = (layer: readonly Neuron[] = []): Activation =>
  layer.length > 0 && layer.every(({ activation }) => activation === 'softmax') ? 'softmax' : 'identity'

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

/** Duplicated neurons, and those of duplicated hidden layers, get the weights of their originals, in and out (running.md 11), in every set. */
export function copyWeights(
  brain: Brain,
  pairs: readonly { readonly from: string; readonly to: string }[],
): Brain {
  const copies = new Map(pairs.map(({ from, to }) => [from, to]))
  const copyOf = (id: string) => copies.get(id) ?? hiddenCopy(id, copies)
  const sets = Object.entries(brain.sets).map(([name, weights]) => [name, copied(weights, copyOf)])
  return {
    ...brain,
    weights: copied(brain.weights, copyOf),
    sets: Object.fromEntries(sets) as Brain['sets'],
  }
}

function hiddenCopy(id: string, copies: ReadonlyMap<string, string>): string | undefined {
  const at = id.lastIndexOf('#')
  const block = at > 0 ? copies.get(id.slice(0, at)) : undefined
  return block === undefined ? undefined : block + id.slice(at)
}

function copied(all: Weights, copyOf: (id: string) => string | undefined): Weights {
  const weights: { [from: string]: { [to: string]: number } } = {}
  for (const [from, row] of Object.entries(all)) {
    const grown = { ...row }
    for (const [to, weight] of Object.entries(row)) {
      const copy = copyOf(to)
      if (copy !== undefined) grown[copy] = weight
    }
    weights[from] = grown
  }
  for (const original of Object.keys(all)) {
    const copy = copyOf(original)
    if (copy !== undefined) weights[copy] = { ...weights[original] }
  }
  return weights
}
