import { expect, test } from 'vitest'
import { errorOn, lossesOn, noExamples, rightIn, withDrive } from './index.ts'

const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
const layers = [['eye'].map(neuron), ['green', 'red'].map(neuron)]
/** Green below, red above, both by the reading alone: 100 − 2x and 2x − 100 with a bias. */
const weights = { eye: { green: -2, red: 2 }, '#bias': { green: 100, red: -100 } }
const pair = (eye: number, green: number, red: number) => ({ inputs: [eye], outputs: [green, red] })
const pairs = [pair(10, 100, -100), pair(90, -100, 100), pair(50, -100, -100), pair(20, -100, 100)]

test('of four lamps three are right: the highest above 0 is the one that was shown, or none is', () => {
  expect(rightIn(layers, weights, pairs, 'one')).toBe(3)
  expect(rightIn(layers, weights, pairs, 'each')).toBe(3)
})

test('each example has its own loss, the mean of the squares of its outputs', () => {
  const expected = [10, 90, 50, 20].map((eye, k) => {
    const says = [1 - eye / 50, eye / 50 - 1]
    return says.reduce((sum, said, j) => sum + (said - pairs[k]!.outputs[j]! / 100) ** 2, 0) / 2
  })
  lossesOn(layers, weights, pairs).forEach((loss, k) => expect(loss).toBeCloseTo(expected[k]!, 12))
})

test('the error of a table is the share that is wrong, or how far it is off, and of no rows there is none', () => {
  const recorded = pairs.map((one, k) => ({ ...one, tick: 6 * k, pose: { x: 1, y: 1, heading: 0 } }))
  const none = noExamples(['eye'], ['green', 'red'])
  const { examples } = withDrive(none, { id: 'd', by: 'pad', seed: 1 }, recorded)
  expect(errorOn(layers, weights, examples, 'one')).toBeCloseTo(25, 12)
  const mean = lossesOn(layers, weights, pairs).reduce((a, b) => a + b) / 4
  expect(errorOn(layers, weights, examples, null)).toBeCloseTo(100 * Math.sqrt(mean), 10)
  expect(errorOn(layers, weights, none, null)).toBeNull()
  expect(errorOn(layers.slice(0, 1).concat([[]]), {}, examples, null)).toBeNull()
})
