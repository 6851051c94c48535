import { atan2 } from './atan2.ts'
import { cos, sin } from './sin-cos.ts'

// All in radians. Within 2 ulp of the exact value, tan away from its poles.

export const tan = (x: number): number => sin(x) / cos(x)
export const atan = (x: number): number => atan2(x, 1)
/** NaN outside −1..1. */
export const asin = (x: number): number => atan2(x, Math.sqrt((1 - x) * (1 + x)))
export const acos = (x: number): number => atan2(Math.sqrt((1 - x) * (1 + x)), x)
