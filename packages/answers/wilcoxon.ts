/** Wilcoxon's signed-rank test of pairs. */
export interface SignedRank {
  /** Pairs that differ; the others are dropped. */
  readonly n: number
  /** Sums of the ranks of what rose, and of what fell. */
  readonly plus: number
  readonly minus: number
  /** Two-sided, exact over all signs; null for more pairs than that is counted for. */
  readonly p: number | null
  /** The smallest p that so many pairs can have at all. */
  readonly smallest: number
  /** Rank-biserial correlation, −1 to 1: above 0 where more rose. */
  readonly r: number
}

/** All sums of ranks of so many pairs are counted in well under a second. */
const mostPairs = 400

/** Twice the mid-ranks of absolute values, so that they are whole numbers. */
function doubledRanks(differences: readonly number[]): readonly number[] {
  const sizes = differences.map(Math.abs)
  return sizes.map((size) => {
    const smaller = sizes.filter((one) => one < size).length
    const same = sizes.filter((one) => one === size).length
    return 2 * smaller + same + 1
  })
}

/** How likely each sum of (doubled) ranks is where every sign is a coin: at index s the probability of s. */
function distribution(ranks: readonly number[]): Float64Array {
  const likely = new Float64Array(ranks.reduce((sum, rank) => sum + rank, 0) + 1)
  likely[0] = 1
  let highest = 0
  for (const rank of ranks) {
    highest += rank
    for (let sum = highest; sum >= 0; sum -= 1)
      likely[sum] = (likely[sum]! + (sum >= rank ? likely[sum - rank]! : 0)) / 2
  }
  return likely
}

/**
 * Did what is measured in pairs change? Zeros are dropped, ties share their ranks.
 * @param differences after minus before, of each pair
 * @returns null where no pair differs
 * Source: F. Wilcoxon, Individual comparisons by ranking methods, Biometrics Bulletin 1, 1945; r: D. S. Kerby, The simple
 * difference formula, Comprehensive Psychology 3, 2014.
 */
export function signedRank(differences: readonly number[]): SignedRank | null {
  const moved = differences.filter((one) => one !== 0)
  const n = moved.length
  if (n === 0) return null
  const ranks = doubledRanks(moved)
  const sum = (rises: boolean) =>
    ranks.reduce((total, rank, at) => total + (moved[at]! > 0 === rises ? rank : 0), 0)
  const [plus, minus] = [sum(true), sum(false)]
  return {
    ...{ n, plus: plus / 2, minus: minus / 2, smallest: smallestFor(n) },
    p: n > mostPairs ? null : twoSided(distribution(ranks), Math.min(plus, minus)),
    r: (plus - minus) / (plus + minus),
  }
}

/** All signs alike, either way. */
const smallestFor = (n: number) =>
  Array(n - 1)
    .fill(0)
    .reduce<number>((p) => p / 2, 1)

function twoSided(likely: Float64Array, least: number): number {
  let tail = 0
  for (let sum = 0; sum <= least; sum += 1) tail += likely[sum]!
  return Math.min(1, 2 * tail)
}
