import type { Distance, Points } from './types.ts'

/**
 * A centre as the loops see it: its numbers one after the other, and for the angle its length. `far` is what labels are
 * chosen by; `shown` what a child reads: for straight distances the root of it.
 */
type Far = (points: Float64Array, at: number, centres: Float64Array, from: number, features: number) => number

const squared: Far = (points, at, centres, from, features) => {
  let sum = 0
  for (let feature = 0; feature < features; feature++) {
    const gap = points[at + feature]! - centres[from + feature]!
    sum += gap * gap
  }
  return sum
}

const blocks: Far = (points, at, centres, from, features) => {
  let sum = 0
  for (let feature = 0; feature < features; feature++)
    sum += Math.abs(points[at + feature]! - centres[from + feature]!)
  return sum
}

/** 1 − cos of the angle between both; a point at the origin has no direction and is 1 away from all. */
const angle: Far = (points, at, centres, from, features) => {
  let [product, a, b] = [0, 0, 0]
  for (let feature = 0; feature < features; feature++) {
    const x = points[at + feature]!
    const y = centres[from + feature]!
    product += x * y
    a += x * x
    b += y * y
  }
  return a === 0 || b === 0 ? 1 : 1 - product / (Math.sqrt(a) * Math.sqrt(b))
}

export const farIn: { readonly [distance in Distance]: Far } = {
  euclidean: squared,
  manhattan: blocks,
  cosine: angle,
}

/** All centres' numbers one after the other. */
export const flat = (centres: readonly (readonly number[])[]): Float64Array =>
  Float64Array.from(centres.flat())

/** Distances of a point to every centre, as they are read: straight ones in the points' unit. */
export function distancesOf(
  points: Points,
  point: number,
  centres: readonly (readonly number[])[],
  distance: Distance,
): number[] {
  const all = flat(centres)
  const { values, features } = points
  return centres.map((_, group) => {
    const far = farIn[distance](values, point * features, all, group * features, features)
    return distance === 'euclidean' ? Math.sqrt(far) : far
  })
}
