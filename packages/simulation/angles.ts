import type { Degrees, Radians } from './types.ts'

/** Degrees of a pose as radians. */
export const radiansOf = (degrees: Degrees): Radians => (degrees * Math.PI) / 180

/** Radians as degrees of a pose, 0 ≤ degrees < 360. */
export const degreesOf = (radians: Radians): Degrees => fullTurn((radians * 180) / Math.PI)

/** The same direction, 0 ≤ degrees < 360. */
export function fullTurn(degrees: Degrees): Degrees {
  const wrapped = degrees - 360 * Math.floor(degrees / 360)
  return wrapped < 360 ? wrapped : 0
}
