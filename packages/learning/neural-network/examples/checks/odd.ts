import type { ShownPair } from '../rows.ts'
import { farApart, type ExampleFinding, type Table } from './types.ts'

const neighbours = 4
/** In percent: a wish so far from what its neighbours wish is odd. */
const far = 35

/** Examples whose wish is far from that of their nearest, or that practice cannot learn. It may be wrong: it asks. */
export function oddOnes({ pairs, errors }: Table): readonly ExampleFinding[] {
  const unlearned = errors ? worstOf(errors) : new Set<number>()
  return pairs.flatMap((pair, at): ExampleFinding[] =>
    unlearned.has(at) || isOdd(pair, pairs) ? [{ kind: 'oddOne', row: pair.row }] : [],
  )
}

function isOdd(pair: ShownPair, pairs: readonly ShownPair[]): boolean {
  if (pairs.length <= neighbours) return false
  const nearest: { readonly off: number; readonly outputs: readonly number[] }[] = []
  for (const other of pairs) {
    if (other === pair) continue
    const off = farApart(pair.inputs, other.inputs)
    if (nearest.length === neighbours && off >= nearest[neighbours - 1]!.off) continue
    const place = nearest.findIndex((one) => one.off > off)
    nearest.splice(place < 0 ? nearest.length : place, 0, { off, outputs: other.outputs })
    nearest.length = Math.min(nearest.length, neighbours)
  }
  const usual = pair.outputs.map((_, k) => median(nearest.map(({ outputs }) => outputs[k]!)))
  return farApart(pair.outputs, usual) > far
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
