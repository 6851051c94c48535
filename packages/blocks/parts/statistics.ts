const sum = (xs: readonly number[]): number => xs.reduce((total, x) => total + x, 0)
const average = (xs: readonly number[]): number => sum(xs) / xs.length

function median(xs: readonly number[]): number {
  const sorted = [...xs].sort((a, b) => a - b)
  const middle = (sorted.length - 1) / 2
  return ((sorted[Math.floor(middle)] ?? 0) + (sorted[Math.ceil(middle)] ?? 0)) / 2
}

/** Of the whole population: √(Σ(x − mean)² / n). */
function deviation(xs: readonly number[]): number {
  const mean = average(xs)
  return Math.sqrt(average(xs.map((x) => (x - mean) * (x - mean))))
}

/** What `math_on_list` works out of numbers; all but SUM need at least one. */
export const statistics: ReadonlyMap<string, (xs: readonly number[]) => number> = new Map([
  ['SUM', sum],
  ['MIN', (xs) => xs.reduce((least, x) => Math.min(least, x), Infinity)],
  ['MAX', (xs) => xs.reduce((most, x) => Math.max(most, x), -Infinity)],
  ['AVERAGE', average],
  ['MEDIAN', median],
  ['STD_DEV', deviation],
])
