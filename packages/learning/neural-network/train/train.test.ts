import { readFileSync } from 'node:fs'
import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { biasRow, forward, layOut } from '../network.ts'
import type { Activation, Brain, Weights } from '../types.ts'
import { backwardOver } from './backward.ts'
import { beginningOf } from './beginning.ts'
import { blockFor } from './block.ts'
import { lossOf, meanLoss, percentOff, rightRows } from './errors.ts'
import { forwardOver } from './forward.ts'
import { layOutTraining, parametersIn, weightsIn } from './layout.ts'
import { obstacleTo } from './obstacles.ts'
import { byHeartSince, practise, sleepingIn } from './practise.ts'
import { mirrored, rowsOf, type Pair } from './rows.ts'
import { starter } from './settings.ts'
import { beginPractice, restorePractice, savePractice } from './state.ts'
import { finishThisRound, step } from './step.ts'
import type { Practice, Settings, TrainTrace } from './types.ts'

const order = (seed: number) => stream(seed, 'learn/order/net')
const neuron = (id: string, activation: Activation = 'identity') => ({ id, activation, bias: 0 })

/** Layers of so many neurons: `n1.0` is the first of the second layer. */
const layersOf = (sizes: readonly number[], hidden: Activation, out: Activation): Brain['layers'] =>
  sizes.map((size, l) =>
    Array.from({ length: size }, (_, k) =>
      neuron(`n${l}.${k}`, l === 0 ? 'identity' : l === sizes.length - 1 ? out : hidden),
    ),
  )

const none = rowsOf([])
const quick: Settings = { ...starter, bias: 'on', order: 'table' }

/** Practice of a network that begins with these parameters. */
function practiceOf(
  layers: Brain['layers'],
  pairs: readonly Pair[],
  settings: Settings,
  parameters?: readonly number[],
  kept: readonly Pair[] = [],
): Practice {
  const net = layOutTraining(layers)
  const weights = parameters ? weightsIn(net, Float64Array.from(parameters)) : {}
  const { shares } = net
  const data = { layers, weights, practised: rowsOf(pairs, { shares }), kept: rowsOf(kept, { shares }) }
  return beginPractice(settings, data, order(1))
}

/** Of each row that is held back, one by one. */
const lossesOf = (practice: Practice): readonly number[] =>
  Array.from({ length: practice.kept.count }, (_, row) => {
    forwardOver(practice, practice.kept.inputs, row)
    return lossOf(practice, practice.kept, row)
  })

type Case = readonly [
  sizes: number[],
  hidden: Activation,
  out: Activation,
  optimizer: 'sgd' | 'adam',
  momentum: number,
  decay: number,
  batch: number,
  start: number[],
  end: number[],
]
const reference = JSON.parse(
  readFileSync(new URL('../reference/practice.json', import.meta.url), 'utf8'),
) as { readonly rows: { readonly [name: string]: number[][] }; readonly cases: readonly Case[] }
const { inputs, wheels, chosen } = reference.rows as {
  inputs: number[][]
  wheels: number[][]
  chosen: number[][]
}

function afterCase([sizes, hidden, out, optimizer, momentum, decay, batch, start]: Case): Float64Array {
  const targets = out === 'softmax' ? chosen.map((row) => row.map((one) => 2 * one - 1)) : wheels
  const pairs = inputs.map((row, at) => ({
    inputs: row.map((value) => 100 * value),
    outputs: targets[at]!.map((value) => 100 * value),
  }))
  const rate = (optimizer === 'adam' ? 0.005 : 0.02) / (out === 'softmax' ? 10 : 1)
  const settings = { ...quick, rate, optimizer, momentum, decay, batch, rounds: 100 }
  const practice = practiceOf(layersOf(sizes, hidden, out), pairs, settings, start)
  while (practice.ended === null) step(practice)
  return practice.parameters
}

describe('100 rounds of practice', () => {
  it('end as PyTorch and NumPy end, within 1e-9, for activations × optimizers × layers × batches', () => {
    let worst = 0
    for (const one of reference.cases) {
      const end = one.at(-1) as number[]
      const found = afterCase(one)
      expect(found).toHaveLength(end.length)
      found.forEach((value, k) => (worst = Math.max(worst, Math.abs(value - end[k]!))))
    }
    expect(worst).toBeLessThan(1e-9)
  })

  it('are tried with all that practice can have', () => {
    const used = (at: number) => new Set(reference.cases.map((one) => one[at]))
    expect(used(1)).toEqual(new Set(['identity', 'relu', 'sigmoid', 'tanh']))
    expect(used(2)).toEqual(new Set(['identity', 'relu', 'sigmoid', 'tanh', 'softmax']))
    expect([used(3), used(6)]).toEqual([new Set(['sgd', 'adam']), new Set([1, 16, 21])])
    expect(new Set(reference.cases.map(([sizes]) => sizes.length))).toEqual(new Set([2, 3, 4]))
  })
})

const percent = fc.integer({ min: 0, max: 100 })
const smooth = fc.constantFrom<Activation>('identity', 'sigmoid', 'tanh')
const network = fc.record({
  sizes: fc.array(fc.integer({ min: 1, max: 4 }), { minLength: 2, maxLength: 4 }),
  hidden: smooth,
  out: fc.constantFrom<Activation>('identity', 'sigmoid', 'tanh', 'softmax'),
  seed: fc.nat(),
})
type Network = typeof network extends fc.Arbitrary<infer One> ? One : never

/** Random weights and rows for a network. */
function drawn({ sizes, hidden, out, seed }: Network, rows: number, settings: Partial<Settings> = {}) {
  const dice = fc.sample(fc.double({ min: -1, max: 1, noNaN: true }), { seed, numRuns: 400 })
  const layers = layersOf(sizes, hidden, out)
  const [width, outputs] = [sizes[0]!, sizes.at(-1)!]
  const pairs = Array.from({ length: rows }, (_, row) => ({
    inputs: Array.from({ length: width }, (_, i) => Math.round(50 + 50 * dice[(row * 7 + i) % 400]!)),
    outputs: Array.from({ length: outputs }, (_, j) =>
      out === 'softmax'
        ? j === row % outputs
          ? 100
          : -100
        : Math.round(100 * dice[(row * 5 + j + 90) % 400]!),
    ),
  }))
  const start = dice.slice(0, layOutTraining(layers).parameters)
  return practiceOf(layers, pairs, { ...quick, ...settings }, start, pairs.slice(0, 2))
}

describe('the gradient', () => {
  it('is that of central differences, for any smooth network', () => {
    fc.assert(
      fc.property(network, (given) => {
        const practice = drawn(given, 5)
        for (let row = 0; row < 5; row++) {
          forwardOver(practice, practice.practised.inputs, row)
          backwardOver(practice, row)
        }
        const h = 1e-5
        practice.parameters.forEach((value, k) => {
          const loss = (at: number) => {
            practice.parameters[k] = at
            return meanLoss(practice, practice.practised)!
          }
          const slope = (loss(value + h) - loss(value - h)) / (2 * h)
          practice.parameters[k] = value
          expect(Math.abs(practice.gradient[k]! / 5 - slope)).toBeLessThan(1e-6)
        })
      }),
      { numRuns: 60, seed: 23 },
    )
  })

  it('of all examples together does not depend on their order', () => {
    fc.assert(
      fc.property(network, fc.nat(), (given, seed) => {
        const after = (way: Settings['order']) => {
          const practice = drawn({ ...given, seed }, 20, { batch: 20, order: way, rounds: 1 })
          finishThisRound(practice)
          return practice.parameters
        }
        const [table, shuffled] = [after('table'), after('shuffled')]
        table.forEach((value, k) => expect(Math.abs(value - shuffled[k]!)).toBeLessThan(1e-12))
      }),
      { numRuns: 40, seed: 24 },
    )
  })
})

describe('practice', () => {
  const settings = { batch: 4, momentum: 0.5, order: 'shuffled', rounds: 6, patience: 2 } as const

  it('gives equal bits in slices of any size, saved and restored between them', () => {
    const given = { sizes: [3, 4, 2], hidden: 'tanh', out: 'identity', seed: 5 } as const
    const start = () => drawn({ ...given, sizes: [...given.sizes] }, 11, settings)
    const plain = start()
    while (plain.ended === null) step(plain)
    for (const slice of [1, 7, 1000]) {
      let practice = start()
      while (practice.ended === null) {
        for (let k = 0; k < slice; k++) step(practice)
        const saved: unknown = JSON.parse(JSON.stringify(savePractice(practice)))
        practice = start()
        restorePractice(practice, saved as ReturnType<typeof savePractice>)
      }
      expect(practice.parameters).toEqual(plain.parameters)
      expect(practice.round).toBe(plain.round)
    }
  })

  it('several examples at once give the bits of one after the other, curve and all', () => {
    const size = fc.integer({ min: 1, max: 9 })
    const kind = fc.constantFrom<Activation>('identity', 'relu', 'sigmoid', 'tanh')
    fc.assert(
      fc.property(
        fc.array(size, { minLength: 2, maxLength: 4 }),
        ...[kind, kind, fc.integer({ min: 4, max: 40 }), fc.constantFrom('sgd' as const, 'adam' as const)],
        (sizes, hidden, out, batch, optimizer) => {
          const pairs = Array.from({ length: 45 }, (_, row) => ({
            inputs: Array.from({ length: sizes[0]! }, (_, i) => (row * 37 + i * 61) % 101),
            outputs: Array.from({ length: sizes.at(-1)! }, (_, j) => ((row * 53 + j * 29) % 201) - 100),
          }))
          const settings: Settings = {
            ...quick,
            order: 'shuffled',
            batch,
            optimizer,
            momentum: 0.9,
            rounds: 4,
          }
          const begun = () => {
            const { parameters } = layOutTraining(layersOf(sizes, hidden, out))
            const start = Array.from({ length: parameters }, (_, k) => ((k * 71) % 41) / 40 - 0.5)
            return practiceOf(layersOf(sizes, hidden, out), pairs, settings, start, pairs.slice(0, 21))
          }
          const [slow, fast] = [begun(), begun()]
          while (slow.ended === null) step(slow)
          while (fast.ended === null) finishThisRound(fast)
          expect([...fast.parameters]).toEqual([...slow.parameters])
          const single = { ...slow, block: blockFor(slow.net) }
          expect(meanLoss(fast, fast.kept)).toBe(lossesOf(single).reduce((a, b) => a + b) / 21)
        },
      ),
      { seed: 12, numRuns: 60 },
    )
  })

  it('runs the network as the robot does', () => {
    fc.assert(
      fc.property(network, (given) => {
        const practice = drawn(given, 3)
        const { net, parameters } = practice
        const brain: Brain = {
          kind: 'network',
          layers: net.neurons,
          weights: weightsIn(net, parameters),
          sets: {},
        }
        const laid = layOut(brain)
        for (let row = 0; row < 3; row++) {
          forwardOver(practice, practice.practised.inputs, row)
          const width = net.layers[0]!.inputs
          const read = [...practice.practised.inputs.subarray(row * width, (row + 1) * width)]
          const outputs = forward(
            laid,
            read.map((value) => 100 * value),
          )
          const { to } = net.layers.at(-1)!
          outputs.forEach((value, j) => expect(practice.values[to + j]! * 100).toBeCloseTo(value, 9))
        }
      }),
      { numRuns: 40, seed: 25 },
    )
  })

  it('of one layer ends at the least squares', () => {
    const pairs = [
      [10, 80, 60, 10],
      [80, 20, 5, 50],
      [60, 60, 30, 35],
      [100, 90, 70, 80],
      [30, 0, 0, 20],
    ].map(([a, b, c, d]) => ({ inputs: [a!, b!], outputs: [c!, d!] }))
    const layers = layersOf([2, 2], 'identity', 'identity')
    const practice = practiceOf(layers, pairs, { ...quick, batch: 5, rate: 0.5, rounds: 20_000 })
    while (practice.ended === null) step(practice)
    // numpy.linalg.lstsq over the columns a, b, 1 in hundredths: the mean square of what it leaves.
    expect(meanLoss(practice, practice.practised)).toBeCloseTo(0.003331112549, 6)
  })

  it('takes up and gives back weights as on the knobs', () => {
    const layers = layersOf([2, 3, 1], 'tanh', 'identity')
    const net = layOutTraining(layers)
    const weights: Weights = {
      'n0.0': { 'n1.0': 0.5, gone: 1 },
      'n1.2': { 'n2.0': -3 },
      [biasRow]: { 'n1.1': 25 },
    }
    const parameters = parametersIn(net, weights)
    expect([...parameters]).toEqual([0.5, 0, 0, 0, 0, 0, 0, 0.25, 0, 0, 0, -3, 0])
    const back = weightsIn(net, parameters, weights)
    expect(back['n0.0']).toEqual({ 'n1.0': 0.5, 'n1.1': 0, 'n1.2': 0, gone: 1 })
    expect(back[biasRow]).toEqual({ 'n1.1': 25 })
  })
})

describe('one example, opened', () => {
  const layers = layersOf([2, 2], 'identity', 'identity')
  const pairs = [{ inputs: [90, 40], outputs: [70, 10] }]

  it('gives the step of the picture: speed × error × input', () => {
    // Bo says 54 where 70 was shown: 0.03 · 0.16 · 0.9 = +0.004.
    const practice = practiceOf(layers, pairs, { ...quick, rate: 0.03, bias: 'off' }, [0.6, 0, 0, 0, 0, 0])
    const traces: TrainTrace[] = []
    step(practice, (one) => traces.push(one))
    const [trace] = traces
    const link = trace!.links.find(({ from, to }) => from === 'n0.0' && to === 'n1.0')!
    expect(link.after - link.before).toBeCloseTo(0.03 * 0.16 * 0.9, 12)
    expect(trace!.neurons.find(({ id }) => id === 'n1.0')).toMatchObject({ target: 0.7, slope: 1 })
  })

  it('multiplies to the change of every weight, factor by factor', () => {
    fc.assert(
      fc.property(network, (given) => {
        const practice = drawn(given, 1, { rate: 0.07 })
        const traces: TrainTrace[] = []
        step(practice, (one) => traces.push(one))
        const [{ neurons, links }] = traces as [TrainTrace]
        const at = new Map(neurons.map((one) => [one.id, one]))
        const outputs = given.sizes.at(-1)!
        for (const { id, value, target, slope, delta } of neurons) {
          if (target === undefined) continue
          const factor = given.out === 'softmax' ? 1 : (2 / outputs) * slope
          expect(delta, id).toBeCloseTo(factor * (value - target), 12)
        }
        for (const { from, to, input, before, after } of links) {
          expect(input).toBe(from === biasRow ? 1 : at.get(from)!.value)
          expect(after - before).toBeCloseTo(-0.07 * at.get(to)!.delta * input, 12)
        }
      }),
      { numRuns: 40, seed: 26 },
    )
  })
})

describe('practice ends honestly', () => {
  const line = (n: number) =>
    Array.from({ length: n }, (_, k) => ({ inputs: [(k * 37) % 101], outputs: [(k * 53) % 101] }))
  const one = layersOf([1, 1], 'identity', 'identity')

  it('when its rounds are done', () => {
    const practice = practiceOf(one, line(6), { ...quick, rounds: 3 })
    expect(practise(practice).map(({ round, kept }) => [round, kept])).toEqual([
      [0, null],
      [1, null],
      [2, null],
      [3, null],
    ])
    expect(practice.ended).toEqual({ kind: 'rounds' })
  })

  it('when its steps were too big: back at the last whole round', () => {
    const practice = practiceOf(one, line(6), { ...quick, rate: 5, rounds: 100 })
    while (practice.ended === null) step(practice)
    expect(practice.ended).toEqual({ kind: 'ranAway', round: practice.round })
    expect(practice.parameters).toEqual(practice.whole)
    expect(practice.parameters.every((value) => Math.abs(value) <= 1000)).toBe(true)
    step(practice)
    expect(practice.ended).toEqual({ kind: 'ranAway', round: practice.round })
  })

  it('when the test gets no better: with the weights of its best round', () => {
    const practised = [{ inputs: [100], outputs: [100] }]
    const kept = [{ inputs: [100], outputs: [30] }]
    const settings = { ...quick, bias: 'off', patience: 5, rounds: 500, rate: 0.05 } as const
    const practice = practiceOf(one, practised, settings, [0, 0], kept)
    const curve = practise(practice)
    const best = curve.slice(0, -1).reduce((a, b) => (b.kept! < a.kept! ? b : a))
    expect(practice.ended).toEqual({ kind: 'noBetter', best: best.round })
    expect(meanLoss(practice, practice.kept)).toBeCloseTo(best.kept!, 12)
  })

  it('knows when it learns by heart: practised better, held back worse', () => {
    const points = [0.0072, 0.0055, 0.0004].map((practised, k) => ({
      ...{ round: [60, 600, 6000][k]!, practised },
      kept: [0.003, 0.0056, 0.0721][k]!,
    }))
    expect(byHeartSince(points)).toBe(60)
    expect(byHeartSince(points.slice(0, 1))).toBeNull()
    expect(byHeartSince(points.map((point) => ({ ...point, kept: null })))).toBeNull()
  })

  it('names hidden neurons that no example wakes', () => {
    const layers = layersOf([1, 2, 1], 'relu', 'identity')
    const practice = practiceOf(layers, line(6), quick, [-1, 1, 0, 0, 1, 1, 0])
    expect(sleepingIn(practice)).toEqual(['n1.0'])
  })

  it('names a neuron that would only wake if the layer before it were silent', () => {
    // z₁ = x + 1 > 0 for every example; z₂ = 0.5 − z₁ < 0.
    const practice = practiceOf(
      layersOf([1, 1, 1, 1], 'relu', 'identity'),
      line(6),
      quick,
      [1, 1, -1, 0.5, 1, 0],
    )
    expect(sleepingIn(practice)).toEqual(['n2.0'])
  })
})

describe('what cannot practise is refused', () => {
  const pairs = [{ inputs: [10, 20], outputs: [100, -100] }]
  const refusal = (layers: Brain['layers'], rows = pairs, shares = false) =>
    obstacleTo({ layers, weights: {}, practised: rowsOf(rows, { shares }), kept: none })

  it('a threshold in the way', () => {
    const layers = layersOf([2, 3, 2], 'threshold', 'identity')
    expect(refusal(layers)).toEqual({ kind: 'threshold', neurons: ['n1.0', 'n1.1', 'n1.2'] })
    expect(() => practiceOf(layers, pairs, quick)).toThrow(RangeError)
    expect(refusal(layersOf([2, 2], 'identity', 'threshold'))).toMatchObject({ kind: 'threshold' })
  })

  it('a threshold beside a path with a slope only keeps its own links', () => {
    const layers = [layersOf([2, 2], 'identity', 'identity')[0]!, [neuron('m', 'threshold'), neuron('n')]]
    expect(refusal(layers)).toBeNull()
    const practice = practiceOf(layers, pairs, quick, [0.1, 0.2, 0.3, 0.4, 0, 0])
    step(practice)
    expect([...practice.parameters.subarray(0, 2), practice.parameters[4]]).toEqual([0.1, 0.2, 0])
    expect(practice.parameters[2]).not.toBe(0.3)
  })

  it.each([
    // z = 10 · 1 + 20 · w percent: 2, 0, −2.
    [-0.4, 1],
    [-0.5, 0],
    [-0.6, 0],
  ])('a threshold with the weights 1 and %d gives %d', (weight, value) => {
    const layers = [layersOf([2, 2], 'identity', 'identity')[0]!, [neuron('m', 'threshold'), neuron('n')]]
    const practice = practiceOf(layers, pairs, quick, [1, weight, 0.3, 0.4, 0, 0])
    forwardOver(practice, practice.practised.inputs, 0)
    expect(practice.values[2]).toBe(value)
  })

  it('softmax beside others, a row that chooses none, no links, no examples', () => {
    const mixed = [layersOf([2, 2], 'identity', 'identity')[0]!, [neuron('m', 'softmax'), neuron('n')]]
    expect(refusal(mixed)).toEqual({ kind: 'softmax' })
    const shares = layersOf([2, 2], 'identity', 'softmax')
    expect(refusal(shares, pairs, true)).toBeNull()
    const noneShown = [...pairs, { inputs: [1, 2], outputs: [-100, -100] }]
    expect(refusal(shares, noneShown, true)).toEqual({ kind: 'none', row: 1 })
    expect(refusal([[neuron('a')]])).toEqual({ kind: 'noLinks' })
    expect(() => practiceOf(layersOf([2, 2], 'identity', 'identity'), [], quick)).toThrow('no examples')
  })

  it('a saved state of another network', () => {
    const practice = practiceOf(layersOf([2, 2], 'identity', 'identity'), pairs, quick)
    const other = practiceOf(layersOf([2, 3, 2], 'tanh', 'identity'), pairs, quick)
    expect(() => restorePractice(practice, savePractice(other))).toThrow(RangeError)
    expect(() => restorePractice(practice, { ...savePractice(practice), at: 9 })).toThrow(RangeError)
  })
})

describe('the beginning', () => {
  const deep = layersOf([2, 3, 1], 'tanh', 'identity')
  const flat = layersOf([2, 2], 'identity', 'identity')
  const dice = (seed = 1) => stream(seed, 'learn/start/net')
  const bound = (layers: Brain['layers'], weights: Weights) => [
    ...parametersIn(layOutTraining(layers), weights).map(Math.abs),
  ]

  it('from zero is 0 without a hidden layer', () => {
    const { weights, shaken } = beginningOf(flat, { 'n0.0': { 'n1.0': 1 } }, 'zero', dice())
    expect([bound(flat, weights), shaken]).toEqual([[0, 0, 0, 0, 0, 0], false])
  })

  it('from zero draws hidden layers within Glorot and He, biases 0', () => {
    fc.assert(
      fc.property(fc.nat(), (seed) => {
        const glorot = bound(deep, beginningOf(deep, {}, 'zero', dice(seed)).weights)
        expect(glorot.slice(0, 6).every((value) => value > 0 && value <= Math.sqrt(6 / 5))).toBe(true)
        expect(glorot.slice(6, 9)).toEqual([0, 0, 0])
        const relu = layersOf([2, 3, 1], 'relu', 'identity')
        expect(
          Math.max(...bound(relu, beginningOf(relu, {}, 'zero', dice(seed)).weights).slice(0, 6)),
        ).toBeLessThanOrEqual(Math.sqrt(3))
      }),
      { numRuns: 30, seed: 27 },
    )
  })

  it('from the knobs is as they stand; only links that are all 0 are shaken apart, by half', () => {
    const knobs: Weights = { 'n0.0': { 'n1.0': 0.5 } }
    expect(beginningOf(deep, knobs, 'knobs', dice())).toEqual({ weights: knobs, shaken: false })
    expect(beginningOf(flat, {}, 'knobs', dice())).toEqual({ weights: {}, shaken: false })
    const { weights, shaken } = beginningOf(deep, { [biasRow]: { 'n1.0': 7 } }, 'knobs', dice())
    const whole = beginningOf(deep, {}, 'zero', dice()).weights
    expect([shaken, weights[biasRow]]).toEqual([true, { 'n1.0': 7 }])
    expect(weights['n0.0']!['n1.0']).toBe(whole['n0.0']!['n1.0']! / 2)
  })
})

describe('rows', () => {
  it('mirrored twice are what they were', () => {
    const mirror = { inputs: [1, 0, 2], outputs: [1, 0] }
    const three = fc.tuple(percent, percent, percent)
    fc.assert(
      fc.property(three, fc.tuple(percent, percent), (ins, outs) => {
        const pair = { inputs: ins, outputs: outs }
        expect(mirrored(mirrored(pair, mirror), mirror)).toEqual(pair)
        expect(rowsOf([pair], { mirror }).count).toBe(2)
      }),
    )
  })

  it('are right where the highest lamp is the shown one, or every word that was shown is above 0', () => {
    const layers = layersOf([1, 2], 'identity', 'identity')
    const pairs = [
      { inputs: [100], outputs: [100, -100] },
      { inputs: [100], outputs: [-100, 100] },
      { inputs: [0], outputs: [-100, -100] },
    ]
    const practice = practiceOf(layers, pairs, quick, [0.9, 0.4, 0, 0])
    expect(rightRows(practice, practice.practised, 'one')).toBe(2)
    expect(rightRows(practice, practice.practised, 'each')).toBe(1)
  })

  it('that are 16 off of 100 are 16 percent off', () => {
    expect(percentOff(0.0256)).toBeCloseTo(16, 9)
  })

  it('stay in 0..1 where that is wanted', () => {
    const practice = practiceOf(
      layersOf([1, 1], 'identity', 'identity'),
      [{ inputs: [100], outputs: [-100] }],
      { ...quick, range: 'unit', rounds: 50 },
      [0.5, 0],
    )
    while (practice.ended === null) step(practice)
    expect(practice.parameters[0]).toBe(0)
    expect(practice.parameters[1]).toBeLessThan(0)
  })
})
