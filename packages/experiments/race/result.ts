import { bandOf, medianOf } from './bands.ts'
import { pointsOf } from './points.ts'
import type { Band, LaneResult, RunRecord, WayThen } from './types.ts'

type Counted = WayThen & { readonly runs: number }

/** All runs of a lane in one: bands, ways and its bill. @param records one or more, of so many tries each */
export function resultOf(records: readonly RunRecord[], tries: number): LaneResult {
  const points = pointsOf(tries)
  const band = (of: (record: RunRecord, at: number) => number): readonly Band[] =>
    points.map((_, at) => bandOf(records.map((record) => of(record, at))))
  const end = (of: (record: RunRecord) => readonly number[]) =>
    medianOf(records.map((record) => of(record).at(-1)!))
  const first = medianOf(records.map((record) => record.first ?? Infinity))
  return {
    runs: records.length,
    curves: {
      moves: band(({ moves }, at) => moves[at]!),
      stars: band(({ stars }, at) => stars[at]!),
      falls: band(({ falls }, at) => falls[at]!),
      pace: band(({ moves }, at) => paceAt(moves, points, at)),
    },
    ways: points.map((_, at) => counted(records.map(({ ways }) => ways[at]!))),
    bill: {
      ...{ tries, moves: end(({ moves }) => moves), stars: end(({ stars }) => stars) },
      falls: end(({ falls }) => falls),
      first: Number.isFinite(first) ? first : null,
      found: records.filter((record) => record.first !== null).length,
      reaches: records[0]!.reaches === null ? null : medianOf(records.map(({ reaches }) => reaches!)),
    },
  }
}

function paceAt(moves: readonly number[], points: readonly number[], at: number): number {
  const [before, since] = at === 0 ? [0, 0] : [moves[at - 1]!, points[at - 1]!]
  return (moves[at]! - before) / (points[at]! - since)
}

/** Equal ways in one, the most frequent first; of equally frequent ones the one that was met first. */
function counted(ways: readonly WayThen[]): readonly Counted[] {
  const found = new Map<string, Counted>()
  for (const way of ways) {
    const name = 'states' in way ? way.states.join('-') : way.reason
    found.set(name, { ...way, runs: (found.get(name)?.runs ?? 0) + 1 })
  }
  return [...found.values()].toSorted((a, b) => b.runs - a.runs)
}
