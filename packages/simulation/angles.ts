import type { Degrees, Pose, Radians } from './types.ts'

/** Degrees of a pose as radians. */
export const radiansOf = (degrees: Degrees): Radians => (degrees * Math.PI) / 180

/** Radians as degrees of a pose, 0 ≤ degrees < 360. */
export const degreesOf = (radians: Radians): Degrees => fullTurn((radians * 180) / Math.PI)

/** The same direction, 0 ≤ degrees < 360. */
export function fullTurn(degrees: Degrees): Degrees {
  const wrapped = degrees - 360 * Math.floor(degrees / 360)
  return wrapped < 360 ? wrapped : 0
}

/** Poses closer than this (cm, degrees) differ by rounding only. */
const ROUNDING = 1e-6

/** Is it the same place, looking the same way? Headings are angles: −90 is 270. */
export const samePose = (a: Pose, b: Pose): boolean =>
  Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + apart(a.heading, b.heading) < ROUNDING

/** The smaller angle between two headings. */
const apart = (a: Degrees, b: Degrees): Degrees => Math.abs(fullTurn(a - b + 180) - 180)
