import { readFileSync } from 'node:fs'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  copyWeights,
  emptyBrain,
  follow,
  forward,
  layOut,
  pruneWeights,
  trace,
  withWeight,
  type Brain,
} from './index.ts'

interface Case {
  inputs: number[]
  weights: number[][][]
  biases: number[][]
  outputs: number[]
}
const cases = JSON.parse(readFileSync(new URL('reference/forward.json', import.meta.url), 'utf8')) as Case[]

const name = (layer: number, neuron: number) => `n${layer}.${neuron}`

function brainOf({ inputs, weights, biases }: Case): Brain {
  const layers = [inputs, ...biases].map((layer, l) =>
    layer.map((bias, n) => ({ id: name(l, n), activation: 'identity' as const, bias: l === 0 ? 0 : bias })),
  )
  const table: { [from: string]: { [to: string]: number } } = {}
  weights.forEach((matrix, l) =>
    matrix.forEach((row, to) =>
      row.forEach((w, from) => ((table[name(l, from)] ??= {})[name(l + 1, to)] = w)),
    ),
  )
  return { kind: 'network', layers, weights: table, sets: {} }
}

describe('a forward pass', () => {
  it('gives what NumPy gives, for networks of one to three layers of links', () => {
    for (const example of cases) {
      const outputs = forward(layOut(brainOf(example)), example.inputs)
      outputs.forEach((value, n) => expect(value).toBeCloseTo(example.outputs[n]!, 9))
      expect(outputs).toHaveLength(example.outputs.length)
    }
  })

  it('opened by a trace gives the same outputs, and its terms add up to its sums', () => {
    for (const example of cases) {
      const brain = brainOf(example)
      const opened = trace(brain, example.inputs)
      const last = brain.layers.at(-1)!
      const outputs = forward(layOut(brain), example.inputs)
      last.forEach(({ id }, n) => expect(opened.outputs[id]).toBeCloseTo(outputs[n]!, 12))
      for (const { id, bias } of brain.layers.slice(1).flat()) {
        const products = opened.terms.filter(({ to }) => to === id).map(({ product }) => product)
        expect(bias + products.reduce((a, b) => a + b, 0)).toBeCloseTo(opened.sums[id]!, 12)
      }
    }
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
    expect(pruneWeights(follow(brain, ['b'], ['l', 'r']))).toEqual({ b: { r: 0.3 } })
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
