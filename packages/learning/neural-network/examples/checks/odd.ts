import { gridOf, nearestOthers, type Grid } from './grid.ts'
import { farApart, type ExampleFinding, type Table } from './types.ts'

const neighbours = 4
/** In percent: a wish so far from what its neighbours wish is odd. */
const far = 35

/** Percent: a cell of the grid in which the nearest are looked for. */
const side = 4

/** Examples whose wish is far from that of their nearest, or that practice cannot learn. It may be wrong: it asks. */
export function oddOnes({ pairs, errors }: Table): readonly ExampleFinding[] {
  const unlearned = errors ? worstOf(errors) : new Set<number>()
  const grid = gridOf(
    pairs.map(({ inputs }) => inputs),
    side,
  )
  return pairs.flatMap(({ row }, at): ExampleFinding[] =>
    unlearned.has(at) || isOdd(at, pairs, grid) ? [{ kind: 'oddOne', row }] : [],
  )
}

function isOdd(at: number, pairs: Table['pairs'], grid: Grid): boolean {
  if (pairs.length <= neighbours) return false
  const { outputs } = pairs[at]!
  const nearest = nearestOthers(grid, at, neighbours).map((other) => pairs[other]!.outputs)
  const usual = outputs.map((_, k) => median(nearest.map((wished) => wished[k]!)))
  return farApart(outputs, usual) > far
}

/** The worst tenth, where it is more than three times the median. */
function worstOf(errors: readonly number[]): ReadonlySet<number> {
  const middle = median(errors)
  const order = errors.map((_, at) => at).sort((a, b) => errors[b]! - errors[a]!)
  const tenth = order.slice(0, Math.floor(errors.length / 10))
  return new Set(tenth.filter((at) => errors[at]! > 3 * middle))
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b)
  const middle = sorted.length / 2
  return sorted.length % 2 === 1 ? sorted[Math.floor(middle)]! : (sorted[middle - 1]! + sorted[middle]!) / 2
}
