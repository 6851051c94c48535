import fc from 'fast-check'
import { expect, test } from 'vitest'
import { curveOf } from './curve.ts'

test('the largest is at the top, nothing at the bottom', () => {
  const { spots, path } = curveOf([8, 4, 0])
  expect(spots.map(({ y }) => y)).toEqual([18, 51, 84])
  expect(path).toBe('M22 18L66 51L110 84')
})

test('before the first round there is no line', () => {
  expect(curveOf([])).toEqual({ spots: [], path: '', every: 0 })
})

test('however many rounds, they lie in the drawing from left to right, and at most six bear a number', () => {
  fc.assert(
    fc.property(fc.array(fc.double({ min: 0, max: 1e9, noNaN: true }), { minLength: 1 }), (inertia) => {
      const { spots, every } = curveOf(inertia)
      expect(spots.every(({ x, y }) => x >= 22 && x <= 190.001 && y >= 17.999 && y <= 84)).toBe(true)
      expect(spots.every(({ x }, at) => at === 0 || x > spots[at - 1]!.x)).toBe(true)
      expect(inertia.filter((_, round) => round % every === 0).length).toBeLessThanOrEqual(6)
    }),
  )
})
