import { SINE } from './coefficients.ts'
import { add, multiply, productOf, sumOf, type Doubled } from './doubled.ts'
import { cosineAfter, quarter, rest, sineSeries } from './sin-cos.ts'

const S1 = SINE[0]
/** What the double of −1/6 cannot hold. */
const S1_LOW = -9.25185853854297e-18

/** Sine and cosine of what is left of x after whole quarter turns, in two doubles each, and which quarter it was, 0..3. */
export function sinCosParts(x: number): { sin: Doubled; cos: Doubled; quarter: number } {
  const turned = quarter(x)
  const [left, tail] = [rest[0]!, rest[1]!]
  const square = productOf(left, left)
  const z = square.high
  const cubed = multiply(square, { high: left, low: 0 })
  const third = productOf(cubed.high, S1)
  const fifth = cubed.high * (S1_LOW + z * sineSeries(z)) + cubed.low * S1
  const start = sumOf(1, -0.5 * z)
  return {
    sin: add({ high: left, low: tail - 0.5 * z * tail }, { high: third.high, low: third.low + fifth }),
    cos: sumOf(start.high, start.low - 0.5 * square.low + (cosineAfter(z) - left * tail)),
    quarter: turned,
  }
}
