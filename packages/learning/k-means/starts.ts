import { draw, type StreamState } from '@botgarten/numbers'
import { farIn } from './distances.ts'
import { pointAt } from './points.ts'
import type { Distance, Points } from './types.ts'

/** Different points of the set as first centres, by chance. */
export function randomStart(points: Points, groups: number, stream: StreamState): number[][] {
  refuse(points, groups)
  const left = Array.from({ length: points.count }, (_, point) => point)
  return Array.from({ length: groups }, () => {
    const [point] = left.splice(Math.floor(draw(stream) * left.length), 1)
    return pointAt(points, point!)
  })
}

/**
 * k-means++ (Arthur & Vassilvitskii 2007): the first centre is any point, each further one a point drawn with a
 * probability that grows with its (squared) distance to the nearest centre so far.
 */
export function plusPlusStart(
  points: Points,
  groups: number,
  distance: Distance,
  stream: StreamState,
): number[][] {
  refuse(points, groups)
  const { values, count, features } = points
  const chosen = [Math.floor(draw(stream) * count)]
  const nearest = new Float64Array(count).fill(Infinity)
  while (chosen.length < groups) {
    const centre = values.subarray(chosen.at(-1)! * features, (chosen.at(-1)! + 1) * features)
    let sum = 0
    for (let point = 0; point < count; point++) {
      const far = farIn[distance](values, point * features, centre, 0, features)
      nearest[point] = Math.min(nearest[point]!, far)
      sum += nearest[point]!
    }
    chosen.push(drawn(nearest, draw(stream) * sum, chosen))
  }
  return chosen.map((point) => pointAt(points, point))
}

/** Where all points lie on centres every further point is as good as any: the first that is free. */
function drawn(weights: Float64Array, at: number, chosen: readonly number[]): number {
  let left = at
  for (let point = 0; point < weights.length; point++) {
    left -= weights[point]!
    if (left < 0 && weights[point]! > 0) return point
  }
  const heaviest = weights.reduce((best, weight, point) => (weight > weights[best]! ? point : best), 0)
  return weights[heaviest]! > 0 ? heaviest : weights.findIndex((_, point) => !chosen.includes(point))
}

function refuse({ count }: Points, groups: number): void {
  if (!Number.isInteger(groups) || groups < 1)
    throw new RangeError(`There are ${groups} groups; one is the least.`)
  if (groups > count) throw new RangeError(`${groups} groups need as many points; there are ${count}.`)
}
