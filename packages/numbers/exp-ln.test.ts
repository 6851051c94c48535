import { describe, expect, test } from 'vitest'
import { acos, asin, atan, exp, ln, log10, pow, tan, tanh } from './index.ts'
import reference from './reference/exp-ln.json' with { type: 'json' }
import { ulps } from './reference/ulps.ts'

type Row = readonly [name: string, of: readonly number[], hi: number, lo: number]
const rows = reference as unknown as readonly Row[]

/** How far the worst row of a function is from the truth, in units of the last place, and where. */
function worst(name: string, found: (...of: readonly number[]) => number) {
  const errors = rows
    .filter((row) => row[0] === name)
    .map(([, of, hi, lo]) => ({ of, error: ulps(found(...of), hi, lo) }))
  expect(errors.length).toBeGreaterThan(100)
  return errors.reduce((a, b) => (a.error >= b.error ? a : b))
}

describe('rule 7: against mpmath (reference/make-exp-ln.py)', () => {
  test.each([
    ['exp', (x: number) => exp(x)],
    ['ln', (x: number) => ln(x)],
    ['log10', (x: number) => log10(x)],
    ['pow', (x: number, y: number) => pow(x, y)],
    ['tanh', (x: number) => tanh(x)],
    ['asin', asin],
    ['acos', acos],
    ['atan', atan],
    ['tan', tan],
  ] as [string, (...of: readonly number[]) => number][])('%s is within 1 ulp', (name, found) => {
    expect(worst(name, found).error, JSON.stringify(worst(name, found).of)).toBeLessThanOrEqual(1)
  })

  test('exp is within 0.54 ulp, the bound that Tang (1989) proves for its table of 32 powers', () => {
    expect(worst('exp', exp).error).toBeLessThanOrEqual(0.54)
  })
})

describe('at the ends', () => {
  test('exp runs over and under, ln of 0 and less', () => {
    expect([exp(710), exp(Infinity), exp(-746), exp(-Infinity), exp(NaN)]).toEqual([
      Infinity,
      Infinity,
      0,
      0,
      NaN,
    ])
    expect([exp(0), exp(-0)]).toEqual([1, 1])
    expect([ln(0), ln(-1), ln(Infinity), ln(NaN)]).toEqual([-Infinity, NaN, Infinity, NaN])
    expect([log10(0), log10(-1), log10(Infinity), log10(NaN)]).toEqual([-Infinity, NaN, Infinity, NaN])
  })

  test('tanh and tan keep the sign of zero; tanh ends at −1 and 1, tan nowhere', () => {
    expect([tanh(0), tanh(-0), tanh(40), tanh(-Infinity), tanh(NaN)]).toEqual([0, -0, 1, -1, NaN])
    expect([tan(0), tan(-0), tan(Infinity), tan(NaN)]).toEqual([0, -0, NaN, NaN])
  })

  test('powers of ten and their logarithms are exact', () => {
    for (let n = 0; n <= 22; n++) {
      expect(pow(10, n)).toBe(Number(`1e${n}`))
      expect(log10(Number(`1e${n}`))).toBe(n)
    }
  })

  test('pow as ECMA-262 has it, also where there is no power', () => {
    const corners = [0, -0, 1, -1, Infinity, -Infinity, NaN]
    const numbers = [...corners, 2, -2, 0.5, -0.5, 3, -3]
    const pairs = corners.flatMap((corner) =>
      numbers.flatMap((x) => [[corner, x] as const, [x, corner] as const]),
    )
    for (const [x, y] of pairs) expect([x, y, pow(x, y)]).toEqual([x, y, Math.pow(x, y)])
  })

  test('asin and acos know nothing beyond −1 to 1', () => {
    expect([asin(1.1), asin(-1.1), acos(1.1), acos(-2)]).toEqual([NaN, NaN, NaN, NaN])
    expect([asin(1), acos(1), acos(-1)]).toEqual([Math.PI / 2, 0, Math.PI])
  })
})
