import { angleOf, atan2 } from './atan2.ts'
import { divide, multiply, productOf, sumOf } from './doubled.ts'
import { sinCosParts } from './sin-cos-parts.ts'

// All in radians, within 1 ulp of the exact value.

export function tan(x: number): number {
  // Below it x³/3 is less than half of the last place; −0 stays −0.
  if (x > -1e-8 && x < 1e-8) return x
  const { sin, cos, quarter } = sinCosParts(x)
  return quarter % 2 === 0 ? divide(sin, cos).high : -divide(cos, sin).high
}

export const atan = (x: number): number => atan2(x, 1)

/** NaN outside −1..1. */
export function asin(x: number): number {
  const { root, more } = aside(x)
  return x < 0 ? -angleOf(-x, root, x * more) : angleOf(x, root, -x * more)
}

/** NaN outside −1..1. */
export function acos(x: number): number {
  const { root, more } = aside(x)
  return angleOf(root, x, x * more)
}

/** √(1 − x²), and what its double cannot hold. */
function aside(x: number): { root: number; more: number } {
  const square = multiply(sumOf(1, -x), sumOf(1, x))
  const root = Math.sqrt(square.high)
  const back = productOf(root, root)
  return { root, more: root > 0 ? (square.high - back.high - back.low + square.low) / (2 * root) : 0 }
}
