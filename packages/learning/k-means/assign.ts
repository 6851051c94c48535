import { farIn } from './distances.ts'
import type { Distance, Points } from './types.ts'

/**
 * Gives every point its nearest centre; of equally near ones the first.
 * @param labels is written
 * @returns the inertia: the sum of what is smallest for each point (squared, for straight distances)
 */
export function assignAll(
  points: Points,
  centres: Float64Array,
  distance: Distance,
  labels: Int32Array,
): number {
  return distance === 'euclidean' && points.features === 2
    ? assignOnPlane(points, centres, labels)
    : assignAnywhere(points, centres, distance, labels)
}

function assignAnywhere(
  { values, count, features }: Points,
  centres: Float64Array,
  distance: Distance,
  labels: Int32Array,
): number {
  const far = farIn[distance]
  const groups = centres.length / features
  let inertia = 0
  for (let point = 0; point < count; point++) {
    let best = 0
    let least = Infinity
    for (let group = 0; group < groups; group++) {
      const away = far(values, point * features, centres, group * features, features)
      if (away < least) {
        least = away
        best = group
      }
    }
    labels[point] = best
    inertia += least
  }
  return inertia
}

/** The same on a plane, without the inner loop: what a playground of thousands of points does in every frame. */
function assignOnPlane({ values, count }: Points, centres: Float64Array, labels: Int32Array): number {
  let inertia = 0
  for (let point = 0; point < count; point++) {
    const x = values[2 * point]!
    const y = values[2 * point + 1]!
    let best = 0
    let least = Infinity
    for (let at = 0; at < centres.length; at += 2) {
      const right = x - centres[at]!
      const up = y - centres[at + 1]!
      const away = right * right + up * up
      if (away < least) {
        least = away
        best = at
      }
    }
    labels[point] = best >> 1
    inertia += least
  }
  return inertia
}
