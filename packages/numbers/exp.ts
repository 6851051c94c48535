import { POWERS_HI, POWERS_LO, STEP, STEPS_PER_ONE } from './powers.ts'

// e^x = 2^whole · 2^(part/32) · e^r with |r| ≤ ln 2 / 64, by a table and a short series (Tang 1989). Every net with a
// curved activation runs through here, so that nothing is allocated. Only + - * / on doubles, which IEEE 754 fixes.

const [STEP_HI, STEP_LO] = STEP
const high = Float64Array.from(POWERS_HI)
const low = Float64Array.from(POWERS_LO)
const SPLITTER = 134217729 // 2^27 + 1

/** 2^-1022 to 2^1023, exactly: at n + BEFORE stands 2^n. */
const BEFORE = 1023
const twoTo = new Float64Array(2047)
twoTo[BEFORE] = 1
for (let n = 1; n <= 1023; n++) twoTo[BEFORE + n] = 2 * twoTo[BEFORE + n - 1]!
for (let n = 1; n <= 1022; n++) twoTo[BEFORE - n] = twoTo[BEFORE - n + 1]! / 2

/** (e^r − 1 − r) / r² by Taylor's series: for |r| ≤ ln 2 / 64 what is left out is below 2^-60 of e^r − 1. */
const beyond = (r: number): number =>
  0.5 + r * (1 / 6 + r * (1 / 24 + r * (1 / 120 + r * (1 / 720 + r * (1 / 5040)))))

/** e to the power x, within 1 ulp where the result is a normal number; the same bits in every engine. */
export function exp(x: number): number {
  if (!(x > -708 && x < 709)) return far(x)
  const steps = Math.floor(x * STEPS_PER_ONE + 0.5)
  return near(x, steps) * twoTo[(steps >> 5) + BEFORE]!
}

/** e^x without its whole power of two: between 0.98 and 2. */
function near(x: number, steps: number): number {
  const rest = x - steps * STEP_HI
  const tail = -steps * STEP_LO
  const r = rest + tail
  const power = high[steps & 31]!
  return power + (low[steps & 31]! + power * (rest + (tail + r * r * beyond(r))))
}

/** Where e^x is not a normal number, or nearly so. */
function far(x: number): number {
  if (x !== x) return NaN
  if (x > 709.79) return Infinity
  if (x < -745.2) return 0
  const steps = Math.floor(x * STEPS_PER_ONE + 0.5)
  const half = (steps >> 5) >> 1
  return near(x, steps) * twoTo[half + BEFORE]! * twoTo[(steps >> 5) - half + BEFORE]!
}

/** The hyperbolic tangent (e^2x − 1) / (e^2x + 1), within 1 ulp, the same bits in every engine. */
export function tanh(x: number): number {
  const size = Math.abs(x)
  // Below it x³/3 is less than half of the last place.
  if (!(size > 1e-8)) return x
  if (size > 22) return x > 0 ? 1 : -1
  const steps = Math.floor(2 * size * STEPS_PER_ONE + 0.5)
  const rest = 2 * size - steps * STEP_HI
  const tail = -steps * STEP_LO
  const r = rest + tail
  const scale = twoTo[(steps >> 5) + BEFORE]!
  const power = high[steps & 31]! * scale
  // e^2x − 1 in two doubles: (power − 1) + rest, exactly, and what is far smaller.
  const small =
    (power - 1) * rest + power * (tail + r * r * beyond(r)) + low[steps & 31]! * scale * (1 + rest)
  const begun = power - 1 + rest
  const above = begun + small
  const aboveTail = rest - (begun - (power - 1)) + (small - (above - begun))
  const value = quotient(above, aboveTail)
  return x > 0 ? value : -value
}

/** n / (n + 2) for n = above + tail > 0: one division, and what its double cannot hold (Dekker 1971). */
function quotient(above: number, tail: number): number {
  const below = above + 2
  const back = below - above
  const belowTail = above - (below - back) + (2 - back) + tail
  const q = above / below
  const product = q * below
  const bigQ = q * SPLITTER
  const upperQ = bigQ - (bigQ - q)
  const lowerQ = q - upperQ
  const bigBelow = below * SPLITTER
  const upper = bigBelow - (bigBelow - below)
  const lower = below - upper
  const lost = upperQ * upper - product + upperQ * lower + lowerQ * upper + lowerQ * lower
  return q + (above - product - lost + tail - q * belowTail) / below
}
