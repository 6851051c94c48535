import { HALF_PI_BITS, TWO_OVER_PI_BITS } from './coefficients.ts'

// Payne & Hanek, Radian reduction for trigonometric functions (1983), in whole numbers: slow and exact. No robot turns
// this far; a child's formula may.

/** Binary places of TWO_OVER_PI_BITS: 971 for the exponent, 53 for the digits and more than enough to spare. */
const PLACES = 1216
const KEPT = 128n
const SCALE = 2.938735877055719e-39 // 2^-128

const double = new Float64Array(1)
const bits = new BigUint64Array(double.buffer)

/** The quarter turn of |x| ≥ 2^20 and what is left of it, in two doubles; NaN left for NaN and ±Infinity. */
export function quarterOfHuge(x: number, rest: Float64Array): number {
  if (!Number.isFinite(x)) {
    rest.fill(NaN)
    return 0
  }
  double[0] = x < 0 ? -x : x
  const places = BigInt(PLACES - (Number(bits[0]! >> 52n) - 1075))
  const digits = (bits[0]! & 0xfffffffffffffn) | 0x10000000000000n
  const turns = digits * TWO_OVER_PI_BITS
  const whole = (turns + (1n << (places - 1n))) >> places
  const left = (turns - (whole << places)) >> (places - KEPT)
  write((left * HALF_PI_BITS) >> KEPT, x < 0 ? -SCALE : SCALE, rest)
  const quarter = Number(whole & 3n)
  return x < 0 ? -quarter & 3 : quarter
}

function write(left: bigint, scale: number, rest: Float64Array): void {
  const hi = Number(left)
  rest[0] = hi * scale
  rest[1] = Number(left - BigInt(hi)) * scale
}
