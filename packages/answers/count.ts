/** How often each option was chosen. */
export function countsOf(options: readonly string[], values: readonly string[]): readonly number[] {
  const counts = options.map(() => 0)
  for (const value of values) {
    const at = options.indexOf(value)
    if (at >= 0) counts[at]! += 1
  }
  return counts
}

export const sumOf = (numbers: readonly number[]): number => numbers.reduce((sum, one) => sum + one, 0)

/** The mean step, where the first option is step 1; null where nobody chose. */
export function meanOf(counts: readonly number[]): number | null {
  const n = sumOf(counts)
  return n === 0 ? null : sumOf(counts.map((count, at) => count * (at + 1))) / n
}

/** The middle step; between two, the number half-way. Null where nobody chose. */
export function medianOf(counts: readonly number[]): number | null {
  const n = sumOf(counts)
  if (n === 0) return null
  const stepAt = (rank: number) => {
    let seen = 0
    return counts.findIndex((count) => (seen += count) > rank) + 1
  }
  return (stepAt(Math.floor((n - 1) / 2)) + stepAt(Math.floor(n / 2))) / 2
}

/** Each option's share of all who chose, 0 to 1; all null where nobody did. */
export function sharesOf(counts: readonly number[]): readonly (number | null)[] {
  const n = sumOf(counts)
  return counts.map((count) => (n === 0 ? null : count / n))
}
