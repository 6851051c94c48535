import fc from 'fast-check'
import { expect, test } from 'vitest'
import { trace, type Brain } from '@botgarten/learning/neural-network'
import { answerOf, courseOf, endsOf, layersBefore, rangeAround, rangeOf, spread } from './function.ts'

const neuron = (id: string, bias = 0) => ({ id, activation: 'identity' as const, bias })
const brain: Brain = {
  kind: 'network',
  layers: [[neuron('a'), neuron('b')], [neuron('h', 4), neuron('g')], [neuron('m', -3)]],
  weights: { a: { h: 0.5, g: -1 }, b: { h: 0.25, g: 0.5 }, h: { m: 2 }, g: { m: 0.5 } },
  sets: {},
}
const now = trace(brain, [40, 80]).outputs

test('a curve is what the network would give, and goes through the point of now', () => {
  const answer = answerOf(brain, brain.weights, now, 'a', 'm')!
  expect(answer({})).toBeCloseTo(now['m']!, 12)
  fc.assert(
    fc.property(fc.integer({ min: 0, max: 100 }), fc.integer({ min: 0, max: 100 }), (a, b) => {
      expect(answer({ a, b })).toBeCloseTo(trace(brain, [a, b]).outputs['m']!, 9)
    }),
    { seed: 7 },
  )
})

test('the lowest and highest value of a function of two inputs are found at the ends and in the middle', () => {
  const ranges = [
    { least: 0, most: 100 },
    { least: -10, most: 10 },
  ] as const
  expect(endsOf((x, y) => x - y, ranges)).toEqual({ least: -10, most: 110 })
  expect(endsOf((x, y) => (x - 50) ** 2 + y ** 2, ranges)).toEqual({ least: 0, most: 2600 })
})

test('the curve of a link inside begins at its own neuron: the others stay as they are', () => {
  const answer = answerOf(brain, brain.weights, now, 'h', 'm')!
  expect(answer({ h: 10 })).toBeCloseTo(2 * 10 + 0.5 * now['g']! - 3, 12)
})

test('there is no curve from an output, backwards, or of neurons that are not there', () => {
  for (const [from, to] of [
    ['m', 'a'],
    ['a', 'b'],
    ['a', 'nobody'],
    ['nobody', 'm'],
  ] as const)
    expect(answerOf(brain, brain.weights, now, from, to)).toBeNull()
})

test('a neuron has reasons in each layer before its own, an input has none', () => {
  expect(
    [...brain.layers.flat(), neuron('other')].map(({ id }) => [id, layersBefore(brain, id).length]),
  ).toEqual([
    ...[
      ['a', 0],
      ['b', 0],
      ['h', 1],
      ['g', 1],
      ['m', 2],
      ['other', 0],
    ],
  ])
})

test('axes hold what is there, in steps of fifty', () => {
  expect(rangeAround([12, 130])).toEqual({ least: 0, most: 150 })
  expect(rangeAround([-20])).toEqual({ least: -50, most: 100 })
  expect(rangeOf(30, true)).toEqual({ least: 0, most: 100 })
  expect(rangeOf(-120, false)).toEqual({ least: -150, most: 150 })
  expect(spread({ least: 0, most: 100 }, 5)).toEqual([0, 25, 50, 75, 100])
})

test('one word says how a curve goes', () => {
  expect(
    [
      [1, 2, 2],
      [2, 1],
      [3, 3, 3],
      [1, 2, 1],
    ].map(courseOf),
  ).toEqual(['rises', 'falls', 'stays', 'bends'])
})
