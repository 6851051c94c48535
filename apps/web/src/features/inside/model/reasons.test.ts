import fc from 'fast-check'
import { expect, test } from 'vitest'
import type { Brain } from '@botgarten/learning/neural-network'
import { barsOf, endToEnd, mostOf, reasonsIn, reasonsOf } from './reasons.ts'

const reasons = (values: readonly number[], weights: readonly number[], base = 0) => {
  const shares = values.map((value, index) => value * weights[index]!)
  const total = shares.reduce((sum, share) => sum + share, base)
  return reasonsOf(
    values.map((value, index) => ({ id: `n${index}`, value, weight: weights[index]! })),
    { shares, base, total, counted: true },
  )
}

test('91 × 0.6 and 100 × 0.2 are 55 and 20, together 75', () => {
  const { rows, total } = reasons([91, 100], [0.6, 0.2])
  expect(rows.map(({ share }) => share)).toEqual([55, 20])
  expect(total).toBe(75)
  expect(rows.map(({ digits }) => digits)).toEqual([0, 0])
})

test('in a deeper network an input has no single weight to the output, in a direct link it has one', () => {
  const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
  const weights = { a: { h: 0.5 }, b: { h: 0.25 }, h: { m: 2 } }
  const brain: Brain = {
    kind: 'network',
    layers: [[neuron('a'), neuron('b')], [neuron('h')], [neuron('m')]],
    ...{ weights, sets: {} },
  }
  const asked = { inputs: [{ id: 'a' }, { id: 'b' }], brain, weights }
  const shown = (id: string) => {
    const { rows, total } = reasonsIn(asked, id, [40, 80])
    return [...rows.map(({ input, weight, share, digits }) => [input, weight, share, digits]), total]
  }
  // 40 × 0.5 = 20 and 80 × 0.25 = 20; × 2 both are 40.
  expect(shown('h')).toEqual([[40, 0.5, 20, 0], [80, 0.25, 20, 0], 40])
  expect(shown('m')).toEqual([[40, null, 40, 0], [80, null, 40, 0], 80])
})

test('numbers below ten have one digit behind the comma', () => {
  const { rows, total, digits } = reasons([3, 4], [0.55, 0.4])
  expect([rows.map(({ share }) => share), total, digits]).toEqual([[1.7, 1.6], 3.3, 1])
})

test('shares as they are seen always add up to the sum as it is seen', () => {
  const lists = fc.array(
    fc.tuple(fc.double({ min: 0, max: 100, noNaN: true }), fc.integer({ min: -100, max: 100 })),
    { maxLength: 9 },
  )
  fc.assert(
    fc.property(lists, fc.integer({ min: -30, max: 30 }), (list, base) => {
      const given = reasons(
        list.map(([value]) => value),
        list.map(([, hundredths]) => hundredths / 100),
        base,
      )
      const unit = 10 ** given.digits
      const whole = [...given.rows, given.base].map(({ share }) => Math.round(share * unit))
      expect(whole.reduce((sum, one) => sum + one, 0)).toBe(Math.round(given.total * unit))
    }),
    { seed: 7 },
  )
})

test('an input has the digits that make its product true, where two are enough', () => {
  // 90.6 × 0.55 = 49.83 → 50, but 91 × 0.55 = 50.05 → 50: no digit is needed.
  expect(reasons([90.6], [0.55]).rows[0]).toMatchObject({ share: 50, digits: 0 })
  // 10.4 × 0.97 = 10.09 → 10; with 10 × 0.97 = 9.7 → 10 it holds too, but 33.4 × 0.92 = 30.73 → 31 needs 33.4: 33 × 0.92 = 30.36.
  expect(reasons([33.4, 10.4], [0.92, 0.97]).rows.map(({ share, digits }) => [share, digits])).toEqual([
    [31, 1],
    [10, 0],
  ])
  expect(reasons([99.5, 0.4], [1, 1]).rows.map(({ digits }) => digits)).toEqual([0, 0])
})

test('bars begin at one line, and the longest reaches its end', () => {
  expect(barsOf([60, 20])).toEqual({
    zero: 0,
    bars: [
      { at: 0, width: 0.75, negative: false },
      { at: 0, width: 0.25, negative: false },
    ],
  })
  const { zero, bars } = barsOf([30, -10])
  expect(zero).toBe(0.25)
  expect(bars[1]).toEqual({ at: 0, width: 0.25, negative: true })
  expect(barsOf([0.5, 0.5]).bars).toEqual(Array(2).fill({ at: 0, width: 0.5, negative: false }))
  expect(barsOf([0, 0]).bars.every(({ width }) => width === 0)).toBe(true)
})

test('parts of a sum lie end to end: what is taken away goes left from the beginning', () => {
  const { zero, bars } = endToEnd([30, -10, 20, -20])
  expect(zero).toBe(0.375)
  expect(bars.map(({ at, width }) => [at, width])).toEqual([
    [0.375, 0.375],
    [0.25, 0.125],
    [0.75, 0.25],
    [0, 0.25],
  ])
})

test('the input that brings most is named, whichever way it pulls; none where all bring nothing', () => {
  expect(mostOf(reasons([50, 80], [1, -1]))?.id).toBe(reasons([50, 80], [1, -1]).rows[1]!.id)
  expect(mostOf(reasons([0, 0], [1, 1]))).toBeNull()
})
