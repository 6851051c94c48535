import { describe, expect, test } from 'vitest'
import { cos, sin } from './index.ts'
import reference from './reference/sin-cos.json' with { type: 'json' }
import { ulps } from './reference/ulps.ts'

describe('rule 7: sin and cos are within 1 ulp of the true value (mpmath, reference/make.py)', () => {
  test('from subnormal to the largest double, and beside multiples of pi/2', () => {
    for (const [x, sinHi, sinLo, cosHi, cosLo] of reference as [number, number, number, number, number][]) {
      expect(ulps(sin(x), sinHi, sinLo), `sin ${x}`).toBeLessThanOrEqual(1)
      expect(ulps(cos(x), cosHi, cosLo), `cos ${x}`).toBeLessThanOrEqual(1)
    }
  })

  test('zeros keep their sign, infinities and NaN give NaN', () => {
    expect([sin(0), sin(-0), cos(0), cos(-0)]).toEqual([0, -0, 1, 1])
    expect([Infinity, -Infinity, NaN].flatMap((x) => [sin(x), cos(x)])).toEqual(Array(6).fill(NaN))
  })

  test('sin is odd and cos is even, to the last bit', () => {
    for (const [x] of reference as [number][]) {
      expect(sin(-x)).toBe(-sin(x))
      expect(cos(-x)).toBe(cos(x))
    }
  })
})
