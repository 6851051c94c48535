import type { Band } from './types.ts'

/** A quantile between two neighbours in proportion: type 7 of Hyndman & Fan 1996, as NumPy's `percentile`. */
function quantile(sorted: readonly number[], share: number): number {
  const place = (sorted.length - 1) * share
  const below = sorted[Math.floor(place)]!
  const above = sorted[Math.ceil(place)]!
  // Also between two runs that never came so far, which count as ∞.
  return above === below ? below : below + (above - below) * (place - Math.floor(place))
}

const ascending = (values: readonly number[]) => values.toSorted((a, b) => a - b)

export const medianOf = (values: readonly number[]): number => quantile(ascending(values), 0.5)

export function bandOf(values: readonly number[]): Band {
  const sorted = ascending(values)
  return { low: quantile(sorted, 0.25), middle: quantile(sorted, 0.5), high: quantile(sorted, 0.75) }
}
