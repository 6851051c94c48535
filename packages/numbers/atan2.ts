import { ARCTANGENT, ATAN_HI, ATAN_LO, HALF_PI, PI } from './coefficients.ts'

// atan of the quotient by a table in steps of 1/32 and a short series (as in Gal's accurate tables); what the
// quotient's double cannot hold is carried along. Only + - * / on doubles, which IEEE 754 fixes to the last bit.

const [A1, A2, A3, A4, A5, A6, A7] = ARCTANGENT
const TABLE_FROM = 0.109375
const TINY = 3.7252902984619140625e-9 // 2^-28: atan q = q
const SPLITTER = 134217729 // 2^27 + 1
// Powers of two, by which nothing is rounded.
const BIG = 7.654505172902098e199 // 2^664
const SMALL = 1.3064201766302604e-200 // 2^-664

/** The angle of the point (x, y) in radians, −pi..pi: within 1 ulp, the same bits in every engine; zeros and infinities as in ECMAScript. */
export const atan2 = (y: number, x: number): number => angleOf(y, x, 0)

/** The same angle, of a point that lies a little further: `more` is what that adds to it. */
export function angleOf(y: number, x: number, more: number): number {
  if (x !== x || y !== y) return NaN
  const up = y < 0 ? -y : y
  const right = x < 0 ? -x : x
  const west = x < 0 || (x === 0 && 1 / x < 0)
  const angle = up > right ? steep(right, up, west, more) : flat(up, right, west, more)
  return y < 0 || (y === 0 && 1 / y < 0) ? -angle : angle
}

/** Angle of a point nearer to the x axis. */
function flat(up: number, right: number, west: boolean, more: number): number {
  if (right === 0) return west ? PI[0] : 0
  const q = right === Infinity ? (up === Infinity ? 1 : 0) : up / right
  return west
    ? fromArctangent(PI[0], PI[1] + more, -1, q, up, right)
    : fromArctangent(0, more, 1, q, up, right)
}

/** Angle of a point nearer to the y axis. */
function steep(right: number, up: number, west: boolean, more: number): number {
  const q = up === Infinity ? 0 : right / up
  return fromArctangent(HALF_PI[0], HALF_PI[1] + more, west ? 1 : -1, q, right, up)
}

/** (hi + lo) + sign · atan(small / large), with q = small / large ≤ 1. */
function fromArctangent(
  hi: number,
  lo: number,
  sign: 1 | -1,
  q: number,
  small: number,
  large: number,
): number {
  if (q < TINY) return hi + (lo + sign * q)
  const tail = remainder(q, small, large) / (1 + q * q)
  const index = q < TABLE_FROM ? 0 : Math.round(q * 32)
  const centre = index / 32
  const t = index === 0 ? q : (q - centre) / (1 + q * centre)
  const z = t * t
  const series = t * z * (A1 + z * (A2 + z * (A3 + z * (A4 + z * (A5 + z * (A6 + z * A7))))))
  if (index === 0) return add(hi, sign * q, lo + sign * (series + tail))
  return add(hi, sign * ATAN_HI[index]!, lo + sign * (ATAN_LO[index]! + (series + tail) + t))
}

/** a + b + c, with what a + b cannot hold. */
function add(a: number, b: number, c: number): number {
  const whole = a + b
  const back = whole - a
  return whole + (a - (whole - back) + (b - back) + c)
}

/** What is missing from q · large to `small`, divided by `large` (Dekker 1971). */
function remainder(q: number, small: number, large: number): number {
  if (large > BIG || large < SMALL) {
    if (large === Infinity) return 0
    const scale = large > BIG ? SMALL : BIG
    return remainder(q, small * scale, large * scale)
  }
  const product = q * large
  const qHi = top(q)
  const qLo = q - qHi
  const largeHi = top(large)
  const largeLo = large - largeHi
  const lost = qHi * largeHi - product + qHi * largeLo + qLo * largeHi + qLo * largeLo
  return (small - product - lost) / large
}

/** The upper 26 bits. */
function top(x: number): number {
  const spread = x * SPLITTER
  return spread - (spread - x)
}
