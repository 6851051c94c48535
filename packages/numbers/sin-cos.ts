import { COSINE, HALF_PI_AFTER_TWO, HALF_PI_PARTS, SINE, TWO_OVER_PI } from './coefficients.ts'
import { quarterOfHuge } from './huge-angles.ts'

// Method: Cody & Waite, Software Manual for the Elementary Functions, with the part that the reduced angle's double
// cannot hold carried along (as in Sun's fdlibm). Only + - * on doubles, which IEEE 754 fixes to the last bit.

const [P1, P2, P3, P4] = HALF_PI_PARTS
const [S1, S2, S3, S4, S5, S6] = SINE
const [C1, C2, C3, C4, C5, C6] = COSINE
const QUARTER_PI = 0.7853981633974483
/** Below it, quarter turns times P1, P2 or P3 are exact. */
const HUGE = 1647098
/** Adding and taking it away again rounds a smaller number to the nearest integer. */
const ROUNDER = 6755399441055744
const NEAR_ZERO = 1e-6
/** Here sin x is x to the last bit, −0 included. */
const TINY = 7.450580596923828e-9

/** What is left of the last angle after whole quarter turns: the double and what it cannot hold. */
export const rest = new Float64Array(2)

/** sin x, x in radians: within 1 ulp, the same bits in every engine; NaN for NaN and ±Infinity. */
export function sin(x: number): number {
  if (x >= -QUARTER_PI && x <= QUARTER_PI) return x > -TINY && x < TINY ? x : sine(x, 0)
  switch (quarter(x)) {
    case 0:
      return sine(rest[0]!, rest[1]!)
    case 1:
      return cosine(rest[0]!, rest[1]!)
    case 2:
      return -sine(rest[0]!, rest[1]!)
    default:
      return -cosine(rest[0]!, rest[1]!)
  }
}

/** cos x, x in radians: within 1 ulp, the same bits in every engine; NaN for NaN and ±Infinity. */
export function cos(x: number): number {
  if (x >= -QUARTER_PI && x <= QUARTER_PI) return cosine(x, 0)
  switch (quarter(x)) {
    case 0:
      return cosine(rest[0]!, rest[1]!)
    case 1:
      return -sine(rest[0]!, rest[1]!)
    case 2:
      return -cosine(rest[0]!, rest[1]!)
    default:
      return sine(rest[0]!, rest[1]!)
  }
}

/** Takes whole quarter turns away; leaves the rest in `rest` and returns which quarter it was, 0..3. */
export function quarter(x: number): number {
  if (!(x > -HUGE && x < HUGE)) return quarterOfHuge(x, rest)
  const n = x * TWO_OVER_PI + ROUNDER - ROUNDER
  const first = x - n * P1
  const second = n * P2
  const left = first - second
  if (left > -NEAR_ZERO && left < NEAR_ZERO) return quarterNearZero(left, n)
  const back = left - first
  const lost = first - (left - back) - (second + back)
  sum(left, lost - n * HALF_PI_AFTER_TWO)
  return n & 3
}

/** `left` is exact here, so that the next two parts of pi/2 can be taken away as well. */
function quarterNearZero(left: number, n: number): number {
  const third = n * P3
  const hi = left - third
  const back = hi - left
  const lost = left - (hi - back) - (third + back)
  sum(hi, lost - n * P4)
  return n & 3
}

function sum(hi: number, lo: number): void {
  const whole = hi + lo
  rest[0] = whole
  rest[1] = lo - (whole - hi)
}

/** sin(x + tail) for |x| ≤ pi/4. */
function sine(x: number, tail: number): number {
  const z = x * x
  return x + (tail - 0.5 * z * tail + z * x * (S1 + z * sineSeries(z)))
}

export const sineSeries = (z: number): number => S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))

/** cos(x + tail) for |x| ≤ pi/4. */
function cosine(x: number, tail: number): number {
  const z = x * x
  const half = 0.5 * z
  const start = 1 - half
  return start + (1 - start - half + (cosineAfter(z) - x * tail))
}

/** cos x − 1 + x²/2, z = x². */
export const cosineAfter = (z: number): number =>
  z * z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))))
