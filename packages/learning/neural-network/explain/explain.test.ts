import { readFileSync } from 'node:fs'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { activations, trace, weightOf, withWeight, type Activation, type Brain } from '../index.ts'
import {
  aboveOf,
  fasterOf,
  roundTogether,
  sharesOf,
  signOf,
  smallestChange,
  type Change,
  type Decision,
} from './index.ts'

interface Case {
  layers: { activation: Activation; weights: number[][]; biases: number[] }[]
  inputs: number[]
  base: number[]
  outputs: number[]
  shares: number[][]
}
const cases = JSON.parse(readFileSync(new URL('reference/shares.json', import.meta.url), 'utf8')) as Case[]

const name = (layer: number, neuron: number) => `n${layer}.${neuron}`

function brainOf({ layers, inputs }: Pick<Case, 'layers' | 'inputs'>): Brain {
  const table: { [from: string]: { [to: string]: number } } = {}
  layers.forEach(({ weights }, l) =>
    weights.forEach((row, to) =>
      row.forEach((w, from) => ((table[name(l, from)] ??= {})[name(l + 1, to)] = w)),
    ),
  )
  const first = inputs.map((_, n) => ({ id: name(0, n), activation: 'identity' as const, bias: 0 }))
  const others = layers.map(({ activation, biases }, l) =>
    biases.map((bias, n) => ({ id: name(l + 1, n), activation, bias })),
  )
  return { kind: 'network', layers: [first, ...others], weights: table, sets: {} }
}

const sum = (numbers: readonly number[]) => numbers.reduce((all, one) => all + one, 0)

test('shares are the mean over all orders of the inputs, as the reference counts them, for every activation', () => {
  for (const example of cases) {
    const brain = brainOf(example)
    brain.layers.at(-1)!.forEach(({ id }, output) => {
      const { shares, base, total, counted } = sharesOf(brain, example.inputs, id)
      expect(counted).toBe(true)
      expect(base).toBeCloseTo(example.base[output]!, 9)
      expect(total).toBeCloseTo(example.outputs[output]!, 9)
      shares.forEach((share, n) => expect(share).toBeCloseTo(example.shares[output]![n]!, 9))
    })
  }
})

const weight = fc.integer({ min: -100, max: 100 }).map((hundredths) => hundredths / 100)
const activation = fc.constantFrom<Activation>(...activations)
const nets = fc.array(fc.integer({ min: 1, max: 4 }), { minLength: 2, maxLength: 4 }).chain((sizes) =>
  fc.record({
    layers: fc.tuple(
      ...sizes.slice(1).map((size, l) =>
        fc.record({
          activation,
          weights: fc.array(fc.array(weight, { minLength: sizes[l]!, maxLength: sizes[l]! }), {
            minLength: size,
            maxLength: size,
          }),
          biases: fc.array(fc.integer({ min: -20, max: 20 }), { minLength: size, maxLength: size }),
        }),
      ),
    ),
    inputs: fc.array(fc.double({ min: 0, max: 100, noNaN: true }), {
      minLength: sizes[0]!,
      maxLength: sizes[0]!,
    }),
  }),
)

test('shares and what is there anyway add up to the value, for any neuron of any network', () => {
  fc.assert(
    fc.property(nets, (net) => {
      const brain = brainOf(net)
      const opened = trace(brain, net.inputs)
      for (const { id } of brain.layers.slice(1).flat()) {
        const { shares, base, total } = sharesOf(brain, net.inputs, id)
        expect(total).toBeCloseTo(opened.outputs[id]!, 9)
        expect(base + sum(shares)).toBeCloseTo(total, 9)
      }
    }),
    { seed: 7 },
  )
})

test('without hidden layers a share is input × weight, to the last bit', () => {
  const brain = brainOf({
    layers: [{ activation: 'identity', weights: [[0.6, 0.2]], biases: [5] }],
    inputs: [0, 0],
  })
  expect(sharesOf(brain, [91, 100], 'n1.0')).toEqual({
    shares: [91 * 0.6, 100 * 0.2],
    base: 5,
    total: 5 + 91 * 0.6 + 100 * 0.2,
    counted: true,
  })
})

test('of very many inputs the shares still add up, and are the same every time', () => {
  const inputs = Array.from({ length: 40 }, (_, n) => 1 + ((n * 37) % 100))
  const row = (k: number) => inputs.map((_, n) => (((n * 13 + k * 7) % 21) - 10) / 10)
  const brain = brainOf({
    layers: [
      { activation: 'identity', weights: [row(0), row(1), row(2)], biases: [3, 4, 5] },
      { activation: 'identity', weights: [[0.5, -0.5, 1]], biases: [1] },
    ],
    inputs,
  })
  const { shares, base, total, counted } = sharesOf(brain, inputs, 'n2.0')
  expect(counted).toBe(false)
  expect(base + sum(shares)).toBeCloseTo(total, 6)
  expect(sharesOf(brain, inputs, 'n2.0').shares).toEqual(shares)
  // Nothing bends here: each order gives the same.
  shares.forEach((share, n) => {
    const alone = sharesOf(
      brain,
      inputs.map((input, k) => (k === n ? input : 0)),
      'n2.0',
    )
    expect(share).toBeCloseTo(alone.total - alone.base, 6)
  })
})

test('missing inputs, inputs that are no number and unknown neurons count nothing', () => {
  const brain = brainOf({
    layers: [{ activation: 'identity', weights: [[0.5, 0.5]], biases: [0] }],
    inputs: [0, 0],
  })
  expect(sharesOf(brain, [NaN], 'n1.0')).toMatchObject({ shares: [0, 0], total: 0 })
  expect(sharesOf(brain, [10, 10], 'nobody')).toMatchObject({ total: 0, base: 0 })
  expect(sharesOf({ kind: 'network', layers: [[], []], weights: {}, sets: {} }, [], 'x').shares).toEqual([])
})

test('rounded parts add up to the rounded sum, and none is a whole unit away from its own', () => {
  const parts = fc.array(fc.double({ min: -300, max: 300, noNaN: true }), { maxLength: 12 })
  fc.assert(
    fc.property(parts, fc.integer({ min: 0, max: 2 }), (list, digits) => {
      const unit = 10 ** digits
      const units = roundTogether(list, digits).map((part) => Math.round(part * unit))
      expect(Math.abs(sum(units) - sum(list) * unit)).toBeLessThanOrEqual(0.5 + 1e-3)
      units.forEach((part, n) => expect(Math.abs(part - list[n]! * unit)).toBeLessThan(1 + 1e-3))
    }),
    { seed: 7 },
  )
  expect(roundTogether([54.6, 20])).toEqual([55, 20])
  expect(roundTogether([33.4, 33.4, 33.4])).toEqual([34, 33, 33])
  expect(roundTogether([0.1 + 0.2, 0.2], 1)).toEqual([0.3, 0.2])
  expect(roundTogether([])).toEqual([])
})

function smallest(...what: Parameters<typeof smallestChange>): Change | null {
  for (const search = smallestChange(...what); ;) {
    const { done, value } = search.next()
    if (done) return value
  }
}

/** Every weight, every hundredth of the range, in no clever order. */
function* allChanges(brain: Brain, least: number, most: number) {
  for (let layer = 1; layer < brain.layers.length; layer++)
    for (const { id: from } of brain.layers[layer - 1]!)
      for (const { id: to } of brain.layers[layer]!)
        for (let hundredths = least * 100; hundredths <= most * 100; hundredths++)
          yield { from, to, before: weightOf(brain.weights, from, to), after: hundredths / 100 }
}

const decide = (brain: Brain, inputs: readonly number[], decision: Decision) => {
  const { outputs } = trace(brain, inputs)
  return decision(brain.layers.at(-1)!.map(({ id }) => outputs[id]!))
}

test('the smallest change is the smallest there is: brute force over every weight finds none smaller', () => {
  const decisions = fc.constantFrom(fasterOf(0, 1), aboveOf(0), signOf(0), aboveOf(0, 40))
  let found = 0
  fc.assert(
    fc.property(nets, decisions, (net, decision) => {
      const brain = brainOf(net)
      const was = decide(brain, net.inputs, decision)
      const turns = (change: Change) => {
        const now = decide(withWeight(brain, change.from, change.to, change.after), net.inputs, decision)
        return was === 0 ? now !== 0 : now === -was
      }
      const size = ({ before, after }: Change) => Math.round(Math.abs(after - before) * 100)
      const sizes = [...allChanges(brain, -1, 1)].filter(turns).map(size)
      const change = smallest(brain, net.inputs, decision, { least: -1, most: 1 })
      expect(change === null ? [] : [size(change)]).toEqual(sizes.length ? [Math.min(...sizes)] : [])
      if (change === null) return
      expect(turns(change)).toBe(true)
      found++
    }),
    { seed: 7, numRuns: 60 },
  )
  expect(found).toBeGreaterThan(20)
})

test('it keeps to the range, but a weight outside may come back towards it', () => {
  const inputs = [100, 50]
  const brain = (left: number, right: number) =>
    brainOf({
      layers: [
        {
          activation: 'identity',
          weights: [
            [left, 0],
            [0, right],
          ],
          biases: [0, 0],
        },
      ],
      inputs,
    })
  expect(smallest(brain(0.5, 0.9), inputs, fasterOf(0, 1))).toEqual({
    from: 'n0.0',
    to: 'n1.0',
    before: 0.5,
    after: 0.44,
  })
  expect(smallest(brain(0.5, 0.9), inputs, fasterOf(0, 1), { least: 0.46, most: 1 })).toMatchObject({
    from: 'n0.0',
    to: 'n1.1',
    after: 0.06,
  })
  expect(smallest(brain(0, 0), [0, 0], fasterOf(0, 1))).toBeNull()
  expect(smallest(brain(2, 0), inputs, signOf(0), { least: -1, most: 1 })).toMatchObject({ after: -0.01 })
})

test('a search leaves the network as it was, and pauses on the way', () => {
  const inputs = Array.from({ length: 10 }, (_, n) => n)
  const weights = [inputs.map(() => 1), inputs.map(() => 0)]
  const brain = brainOf({ layers: [{ activation: 'identity', weights, biases: [0, 0] }], inputs })
  const before = structuredClone(brain)
  const search = smallestChange(brain, inputs, () => 1)
  expect(search.next()).toEqual({ done: false, value: undefined })
  expect(brain).toEqual(before)
})
