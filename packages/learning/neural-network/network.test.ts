import { readFileSync } from 'node:fs'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  activations,
  biasRow,
  copyWeights,
  emptyBrain,
  follow,
  forward,
  hiddenId,
  layOut,
  pruneWeights,
  trace,
  withActivation,
  withoutWeights,
  withWeight,
  type Activation,
  type Brain,
} from './index.ts'

it('a net has as many inputs as the first layer has neurons', () => {
  const neuron = (id: string) => ({ id, bias: 0, activation: 'identity' as const })
  const layers = [['a', 'b', 'c'].map(neuron), [neuron('d')]]
  expect(layOut({ ...emptyBrain, layers }).inputs).toBe(3)
  expect(layOut({ ...emptyBrain, layers: [] }).inputs).toBe(0)
})

type Layer = readonly [
  activations: readonly Activation[],
  biases: readonly number[],
  weights: readonly number[][],
]
type Case = readonly [layers: readonly Layer[], inputs: readonly number[], outputs: readonly number[]]
const cases = JSON.parse(readFileSync(new URL('reference/forward.json', import.meta.url), 'utf8')) as Case[]

const name = (layer: number, neuron: number) => `n${layer}.${neuron}`

/** Every second one has its biases in the neurons, the others among the weights. */
function brainOf([layers, inputs]: Case, index: number): Brain {
  const table: { [from: string]: { [to: string]: number } } = {}
  const set = (from: string, to: string, weight: number) => ((table[from] ??= {})[to] = weight)
  const neurons = layers.map(([activations, biases, weights], l) =>
    activations.map((activation, to) => {
      const id = name(l + 1, to)
      weights[to]!.forEach((weight, from) => set(name(l, from), id, weight))
      if (index % 2 === 1) set(biasRow, id, biases[to]!)
      return { id, activation, bias: index % 2 === 1 ? 0 : biases[to]! }
    }),
  )
  const first = inputs.map((_, n) => ({ id: name(0, n), activation: 'identity' as const, bias: 0 }))
  return { kind: 'network', layers: [first, ...neurons], weights: table, sets: {} }
}

describe('a forward pass', () => {
  it('gives what NumPy gives, within 1e-12 of the scale, for 500 networks of one to four layers of links', () => {
    let worst = 0
    cases.forEach((example, index) => {
      const [layers, inputs, expected] = example
      const outputs = forward(layOut(brainOf(example, index)), inputs)
      expect(outputs).toHaveLength(layers.at(-1)![0].length)
      outputs.forEach((value, n) => {
        const error = Math.abs(value - expected[n]!) / Math.max(100, Math.abs(expected[n]!))
        worst = Math.max(worst, error)
      })
    })
    expect(cases).toHaveLength(500)
    expect(worst).toBeLessThan(1e-12)
  })

  it('is tried with every activation, alone and together', () => {
    const used = new Set(cases.flatMap(([layers]) => layers.flatMap(([names]) => names)))
    expect([...used].sort()).toEqual([...activations].sort())
    expect(new Set(cases.map(([layers]) => layers.length))).toEqual(new Set([1, 2, 3, 4]))
  })

  it('opened by a trace gives the same outputs, and its terms and biases add up to its sums, to the last bit', () => {
    cases.forEach((example, index) => {
      const brain = brainOf(example, index)
      const opened = trace(brain, example[1])
      const outputs = forward(layOut(brain), example[1])
      brain.layers.at(-1)!.forEach(({ id }, n) => expect(opened.outputs[id]).toBe(outputs[n]!))
      for (const { id } of brain.layers.slice(1).flat()) {
        const products = opened.terms.filter(({ to }) => to === id).map(({ product }) => product)
        expect(opened.biases[id]! + products.reduce((a, b) => a + b, 0)).toBe(opened.sums[id])
      }
    })
  })

  it('shares 100 among the neurons with softmax, whatever they add up to', () => {
    const sums = fc.array(fc.double({ min: -1e9, max: 1e9, noNaN: true }), { minLength: 1, maxLength: 9 })
    fc.assert(
      fc.property(sums, (biases) => {
        const outputs = biases.map((bias, n) => ({ id: name(1, n), activation: 'softmax' as const, bias }))
        const shares = forward(layOut({ ...emptyBrain, layers: [[], outputs] }), [])
        expect(shares.reduce((a, b) => a + b, 0)).toBeCloseTo(100, 9)
        biases.forEach((bias, n) =>
          biases.forEach((other, m) => bias > other && expect(shares[n]).toBeGreaterThanOrEqual(shares[m]!)),
        )
      }),
      { seed: 7 },
    )
  })

  it('counts missing inputs as 0 and runs a network without neurons', () => {
    const brain = withWeight(follow(emptyBrain, ['a', 'b'], ['m']), 'b', 'm', 0.5)
    expect(forward(layOut(brain), [7])).toEqual([0])
    expect(forward(layOut(emptyBrain), [])).toEqual([])
  })
})

describe('rule 11: weights while blocks are edited', () => {
  const brain = withWeight(
    withWeight(follow(emptyBrain, ['a', 'b'], ['l', 'r']), 'a', 'l', 0.8),
    'b',
    'r',
    0.3,
  )

  it('a neuron that is taken out and put back has its weights again', () => {
    const without = follow(brain, ['b'], ['l', 'r'])
    expect(forward(layOut(without), [100])).toEqual([0, 30])
    expect(forward(layOut(follow(without, ['a', 'b'], ['l', 'r'])), [100, 100])).toEqual([80, 30])
  })

  it('a duplicated neuron has the weights of its original', () => {
    const doubled = follow(copyWeights(brain, [{ from: 'a', to: 'a2' }]), ['a', 'b', 'a2'], ['l', 'r'])
    expect(doubled.weights['a2']).toEqual({ l: 0.8 })
    const outputs = follow(copyWeights(brain, [{ from: 'l', to: 'l2' }]), ['a', 'b'], ['l', 'l2', 'r'])
    expect(forward(layOut(outputs), [100, 0])).toEqual([80, 80, 0])
  })

  it('a file holds only links that exist', () => {
    const grown = withWeight(follow(brain, ['b'], ['l', 'r']), biasRow, 'r', -20)
    expect(pruneWeights(grown, grown.weights)).toEqual({ b: { r: 0.3 }, [biasRow]: { r: -20 } })
  })

  const hidden = (block: string, count: number, activation: Activation = 'relu') =>
    Array.from({ length: count }, (_, k) => ({ id: hiddenId(block, k + 1), activation }))

  it('a hidden layer that is taken out and put back has its weights again, and follows the activation of its block', () => {
    const deep = withWeight(follow(brain, ['a', 'b'], hidden('h', 2), ['l', 'r']), 'h#2', 'r', -0.5)
    const without = follow(deep, ['a', 'b'], ['l', 'r'])
    expect(forward(layOut(without), [100, 100])).toEqual([80, 30])
    const back = follow(without, ['a', 'b'], hidden('h', 2, 'tanh'), ['l', 'r'])
    expect(back.weights).toEqual(deep.weights)
    expect(back.layers[1]!.map(({ activation }) => activation)).toEqual(['tanh', 'tanh'])
  })

  it('a duplicated hidden layer has the weights of its original, in and out', () => {
    let deep = follow(brain, ['a'], hidden('h', 2), ['l'])
    deep = withWeight(withWeight(deep, 'a', 'h#1', 0.4), 'h#2', 'l', 0.7)
    const doubled = copyWeights(deep, [{ from: 'h', to: 'k' }])
    expect([doubled.weights['a']!['k#1'], doubled.weights['k#2']!['l']]).toEqual([0.4, 0.7])
  })

  it('a bias belongs to the weights it was set with: to the knobs or to a named set', () => {
    const set = withWeight(brain, biasRow, 'l', -30, 'night')
    expect(forward(layOut(set), [100, 0])).toEqual([80, 0])
    expect(forward(layOut(set, set.sets['night']), [100, 0])).toEqual([50, 0])
    expect(forward(layOut(set, withoutWeights(set, 'night').sets['night']), [100, 0])).toEqual([0, 0])
  })

  it('softmax is for all outputs or none, and for an output that is added', () => {
    const names = ({ layers }: Brain) => layers.at(-1)!.map(({ activation }) => activation)
    const shares = withActivation(brain, 'l', 'softmax')
    expect(names(shares)).toEqual(['softmax', 'softmax'])
    expect(names(follow(shares, ['a', 'b'], ['l', 'r', 's']))).toEqual(['softmax', 'softmax', 'softmax'])
    expect(names(withActivation(shares, 'r', 'tanh'))).toEqual(['identity', 'tanh'])
  })

  it('following the same blocks changes nothing, for any network', () => {
    const ids = fc.uniqueArray(fc.string({ minLength: 1, maxLength: 6 }), { minLength: 2, maxLength: 8 })
    fc.assert(
      fc.property(ids, fc.nat(), (names, cut) => {
        const at = cut % names.length
        const once = follow(emptyBrain, names.slice(0, at), names.slice(at))
        expect(follow(once, names.slice(0, at), names.slice(at))).toBe(once)
      }),
    )
  })
})
