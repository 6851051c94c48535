import { assignAll } from './assign.ts'
import { moveAll } from './move.ts'
import type { Distance, Points } from './types.ts'

/** What a round has done. */
interface Round {
  /** Of the centres that it began with. */
  readonly inertia: number
  /** Has any point changed its group? */
  readonly changed: boolean
  /** Where the centres belong now. */
  readonly centres: Float64Array
}

/** One whole round: all points find their centres, and where these would move. `labels` (−1: none yet) is written. */
export function roundOf(
  points: Points,
  centres: Float64Array,
  distance: Distance,
  labels: Int32Array,
): Round {
  if (distance === 'euclidean' && points.features === 2) return roundOnPlane(points, centres, labels)
  const before = labels.slice()
  const inertia = assignAll(points, centres, distance, labels)
  let changed = false
  for (let point = 0; point < labels.length; point++) changed ||= labels[point] !== before[point]
  return { inertia, changed, centres: moveAll(points, labels, centres, distance).centres }
}

/**
 * The same on a plane in one pass. A point nearer to its centre than half of the way from there to the next centre has no
 * nearer one (the triangle inequality): most points are asked for one distance. All in one loop: this is what thousands of
 * points wait for.
 */
function roundOnPlane(points: Points, centres: Float64Array, labels: Int32Array): Round {
  const { values, count } = points
  const safe = safeAround(centres)
  const sums = new Float64Array(centres.length)
  const counts = new Int32Array(safe.length)
  let inertia = 0
  let changed = false
  for (let point = 0; point < count; point++) {
    const x = values[2 * point]!
    const y = values[2 * point + 1]!
    const own = labels[point]!
    // Its own centre first: another one is seldom nearer.
    let best = own < 0 ? 0 : own
    let least = squareTo(x, y, centres, best)
    if (least >= safe[best]!) {
      for (let group = 0; group < safe.length; group++) {
        const away = squareTo(x, y, centres, group)
        if (away < least || (away === least && group < best)) {
          least = away
          best = group
        }
      }
    }
    if (best !== own) {
      labels[point] = best
      changed = true
    }
    inertia += least
    counts[best]!++
    sums[2 * best]! += x
    sums[2 * best + 1]! += y
  }
  const moved = counts.includes(0)
    ? moveAll(points, labels, centres, 'euclidean').centres
    : sums.map((sum, at) => sum / counts[at >> 1]!)
  return { inertia, changed, centres: moved }
}

function squareTo(x: number, y: number, centres: Float64Array, group: number): number {
  const right = x - centres[2 * group]!
  const up = y - centres[2 * group + 1]!
  return right * right + up * up
}

/** By group: the square of half the way to the next centre, a little less for what rounding does. */
function safeAround(centres: Float64Array): Float64Array {
  const safe = new Float64Array(centres.length / 2).fill(Infinity)
  for (let group = 0; group < safe.length; group++)
    for (let other = 0; other < safe.length; other++) {
      if (other === group) continue
      const away = squareTo(centres[2 * group]!, centres[2 * group + 1]!, centres, other)
      safe[group] = Math.min(safe[group]!, (away / 4) * (1 - 1e-9))
    }
  return safe
}
