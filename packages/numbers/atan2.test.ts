import { describe, expect, test } from 'vitest'
import { ATAN_HI, ATAN_LO } from './coefficients.ts'
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

  test('a point that is 2^n times as far away has the same angle, to the last bit', () => {
    const points = Array.from({ length: 36 }, (_, k) => [(k + 1) / 37, 1.1] as const)
    for (const [y, x] of [...points, ...points.map(([y]) => [1.3, y] as const)])
      for (const power of [-900, -664, 664, 900])
        expect(atan2(y * 2 ** power, x * 2 ** power), `${y} ${x} ${power}`).toBe(atan2(y, x))
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

/** atan(index / 32) · 2^200 by Euler's series: Σ 2^2k (k!)² / (2k + 1)! · x^(2k + 1) / (1 + x²)^(k + 1). */
function arctangent(index: number): bigint {
  const n = BigInt(index)
  const square = n * n + 1024n
  let term = ((n * 32n) << 200n) / square
  let sum = 0n
  for (let k = 1n; term > 0n; k++) {
    sum += term
    term = (term * 2n * k * n * n) / ((2n * k + 1n) * square)
  }
  return sum
}

test.each(ATAN_HI.map((_, index) => index))('the table holds atan(%d / 32) to 105 bits', (index) => {
  // Times a power of two, both doubles are whole numbers.
  const stored = (BigInt(ATAN_HI[index]! * 2 ** 60) << 140n) + (BigInt(ATAN_LO[index]! * 2 ** 120) << 80n)
  const off = stored - arctangent(index)
  expect(off < 0n ? -off : off).toBeLessThan(1n << 95n)
})
