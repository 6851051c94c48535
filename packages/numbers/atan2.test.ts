import { describe, expect, test } from 'vitest'
import { atan2 } from './index.ts'
import reference from './reference/atan2.json' with { type: 'json' }
import { ulps } from './reference/ulps.ts'

const { PI } = Math

describe('rule 7: atan2 is within 1 ulp of the true value (mpmath, reference/make.py)', () => {
  test('in all quadrants, from subnormal to the largest double', () => {
    for (const [y, x, hi, lo] of reference as [number, number, number, number][]) {
      expect(ulps(atan2(y, x), hi, lo), `atan2 ${y} ${x}`).toBeLessThanOrEqual(1)
    }
  })

  // ECMAScript, Math.atan2.
  test.each([
    [0, 0, 0],
    [-0, 0, -0],
    [0, -0, PI],
    [-0, -0, -PI],
    [0, 5, 0],
    [-0, 5, -0],
    [0, -5, PI],
    [-0, -5, -PI],
    [5, 0, PI / 2],
    [-5, -0, -PI / 2],
    [5, Infinity, 0],
    [-5, Infinity, -0],
    [5, -Infinity, PI],
    [-5, -Infinity, -PI],
    [Infinity, 5, PI / 2],
    [-Infinity, -5, -PI / 2],
    [Infinity, Infinity, PI / 4],
    [Infinity, -Infinity, (3 * PI) / 4],
    [-Infinity, Infinity, -PI / 4],
    [-Infinity, -Infinity, (-3 * PI) / 4],
    [NaN, 1, NaN],
    [1, NaN, NaN],
  ])('atan2(%d, %d) = %d', (y, x, angle) => {
    expect(atan2(y, x)).toBe(angle)
  })
})
