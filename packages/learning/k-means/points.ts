import type { Points } from './types.ts'

/** The largest value: squares of differences of it, over a hundred features and a million points, can still be added. */
export const LARGEST = 1e140

/** @throws RangeError for no points, rows of unequal length, values that are not finite or larger than `LARGEST` */
export function pointsOf(rows: readonly (readonly number[])[]): Points {
  const features = rows[0]?.length ?? 0
  if (features === 0) throw new RangeError('There are no points.')
  const values = new Float64Array(rows.length * features)
  rows.forEach((row, point) => {
    if (row.length !== features)
      throw new RangeError(`Point ${point} has ${row.length} features, the others have ${features}.`)
    row.forEach((value, feature) => {
      if (!Number.isFinite(value))
        throw new RangeError(`Feature ${feature} of point ${point} is ${value}, not a number that counts.`)
      if (Math.abs(value) > LARGEST)
        throw new RangeError(`Feature ${feature} of point ${point} is ${value}; ${LARGEST} is the most.`)
      values[point * features + feature] = value
    })
  })
  return { values, count: rows.length, features }
}

export const pointAt = ({ values, features }: Points, point: number): number[] => [
  ...values.subarray(point * features, (point + 1) * features),
]
