import type { Brain } from '@botgarten/learning/neural-network'
import { expect, test } from 'vitest'
import { dotsOf, kindOf, meansOf, seaOf, stripesOf, turnAt } from './sea.ts'

const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
const layers = [
  [neuron('a'), neuron('b')],
  [neuron('l'), neuron('r')],
]
const weights = { a: { l: 0.8, r: 0 }, b: { l: 0, r: 0.8 } }
const brain: Brain = { kind: 'network', layers, weights, sets: {} }
const wheels = { left: 0, right: 1 }

test('with each eye on its own wheel the sea is left above the diagonal and right below it', () => {
  const { cells, kinds } = seaOf(brain, weights, [], wheels)!
  const at = (x: number, y: number) => turnAt(kinds[Math.floor(y * cells) * cells + Math.floor(x * cells)]!)
  expect(at(0.2, 0.8)).toBe('left')
  expect(at(0.8, 0.2)).toBe('right')
  expect(at(0.5, 0.5)).toBe('straight')
  expect(at(0, 0)).toBe('stand')
})

test('its stripes cover every place once, each with its kind', () => {
  const sea = seaOf(brain, weights, [], wheels)!
  const painted = new Int8Array(sea.kinds.length).fill(-9)
  const stripes = stripesOf(sea)
  for (const { kind, row, column, length } of stripes)
    painted.fill(kind, row * sea.cells + column, row * sea.cells + column + length)
  expect(painted).toEqual(sea.kinds)
  expect(stripes.reduce((sum, { length }) => sum + length, 0)).toBe(sea.kinds.length)
  expect(stripes.length).toBeLessThan(5 * sea.cells)
})

test('of lamps the highest above 0 is the one that is shown', () => {
  expect(kindOf([-5, 3, 7], null)).toBe(2)
  expect(kindOf([-5, -3], null)).toBe(-1)
})

test('an output of exactly 0 is not above 0, and of two equal outputs the first is shown', () => {
  expect(kindOf([0, -1], null)).toBe(-1)
  expect(kindOf([3, 3], null)).toBe(0)
})

test('a network with one input has no sea', () => {
  expect(seaOf({ ...brain, layers: [[neuron('a')], layers[1]!] }, weights, [], wheels)).toBeNull()
})

const drive = { id: 'hand-1', by: 'hand', seed: 0 } as const
const row = (at: number, inputs: readonly (number | null)[], outputs: readonly (number | null)[]) => ({
  ...{ at, number: at + 1, on: true, drive, inputs, outputs, pose: null },
})

test('a row is a dot in the colour of its wish, and one with a gap is none', () => {
  const dots = dotsOf([row(0, [10, 20], [80, 20]), row(1, [10, null], [1, 1])], wheels)
  expect(dots.map(({ x, y, kind }) => [x, y, turnAt(kind)])).toEqual([[10, 20, 'right']])
  expect(meansOf([row(0, [10, 20], [1, 1]), row(1, [30, null], [1, 1])], 3)).toEqual([20, 20, 0])
})
