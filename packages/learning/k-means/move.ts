import { farIn } from './distances.ts'
import type { Distance, Points } from './types.ts'

/** Where the centres of all groups belong, and which point an empty group takes. */
export interface Moved {
  readonly centres: Float64Array
  /** By group: the point that it takes because it was empty; −1 for the others. */
  readonly takes: Int32Array
}

/**
 * New centres: the mean of a group's points (euclidean), their median (manhattan), the mean direction (cosine). An empty
 * group takes the point that is farthest from its own centre, which leaves its group for that; a second one the next.
 * Where all points lie on their centres an empty group stays where it was. The rule of scikit-learn's
 * `_relocate_empty_clusters_dense`.
 */
export function moveAll(
  points: Points,
  labels: Int32Array,
  centres: Float64Array,
  distance: Distance,
): Moved {
  const groups = centres.length / points.features
  const own = labels.slice()
  const takes = takeForEmpty(points, own, centres, distance, groups)
  const moved =
    distance === 'manhattan' ? mediansOf(points, own, centres) : meansOf(points, own, centres, distance)
  return { centres: moved, takes }
}

function takeForEmpty(
  points: Points,
  labels: Int32Array,
  centres: Float64Array,
  distance: Distance,
  groups: number,
): Int32Array {
  const takes = new Int32Array(groups).fill(-1)
  const counts = new Int32Array(groups)
  for (const label of labels) counts[label]!++
  const empty = [...counts.keys()].filter((group) => counts[group] === 0)
  if (empty.length === 0) return takes
  const { values, features } = points
  const away = Array.from(labels, (label, point) =>
    farIn[distance](values, point * features, centres, label * features, features),
  )
  const farthest = [...away.keys()].sort((a, b) => away[b]! - away[a]! || a - b)
  empty.forEach((group, index) => {
    const point = farthest[index]
    if (point === undefined || away[farthest[0]!] === 0) return
    takes[group] = point
    labels[point] = group
  })
  return takes
}

function meansOf(
  { values, count, features }: Points,
  labels: Int32Array,
  before: Float64Array,
  distance: Distance,
): Float64Array {
  const sums = new Float64Array(before.length)
  const counts = new Int32Array(before.length / features)
  for (let point = 0; point < count; point++) {
    const group = labels[point]!
    const weight = distance === 'cosine' ? inverseLength(values, point * features, features) : 1
    counts[group]!++
    for (let feature = 0; feature < features; feature++)
      sums[group * features + feature]! += weight * values[point * features + feature]!
  }
  for (let at = 0; at < sums.length; at++) {
    const members = counts[Math.floor(at / features)]!
    sums[at] = members === 0 ? before[at]! : sums[at]! / members
  }
  return sums
}

/** Points weigh equally by direction, however far out they are; one at the origin has none. */
function inverseLength(values: Float64Array, at: number, features: number): number {
  let sum = 0
  for (let feature = 0; feature < features; feature++) sum += values[at + feature]! * values[at + feature]!
  return sum === 0 ? 0 : 1 / Math.sqrt(sum)
}

function mediansOf({ values, features }: Points, labels: Int32Array, before: Float64Array): Float64Array {
  const moved = before.slice()
  for (let group = 0; group < before.length / features; group++) {
    const members = [...labels.keys()].filter((point) => labels[point] === group)
    if (members.length === 0) continue
    for (let feature = 0; feature < features; feature++)
      moved[group * features + feature] = medianOf(
        members.map((point) => values[point * features + feature]!),
      )
  }
  return moved
}

function medianOf(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b)
  const middle = sorted.length / 2
  return (sorted[Math.ceil(middle) - 1]! + sorted[Math.floor(middle)]!) / 2
}
