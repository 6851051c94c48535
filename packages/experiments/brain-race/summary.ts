import { billOf, type Bill } from './bill.ts'
import type { Lane } from './race.ts'
import type { Course, LaneKind, LaneResult, Run } from './types.ts'

/** A lane over all starts. */
export interface Summary {
  readonly kind: LaneKind
  /** Means over the starts. */
  readonly score: number
  readonly cm: number
  readonly atWall: number
  /** Sums over the starts. */
  readonly bumps: number
  readonly decisions: number
  readonly bill: Bill
}

/** Of each lane in its order; null: it was not ready. */
export function summariesOf(results: readonly LaneResult[], lanes: readonly Lane[]): (Summary | null)[] {
  return results.map(({ kind, runs }) => {
    const racer = lanes.find((lane) => lane.kind === kind)?.racer
    if (!runs || !racer) return null
    const mean = (of: (run: Run) => number) => sum(runs, of) / runs.length
    return {
      ...{ kind, score: mean(({ score }) => score), cm: mean(({ cm }) => cm) },
      ...{ atWall: mean(({ atWall }) => atWall), bumps: sum(runs, ({ bumps }) => bumps) },
      ...{ decisions: sum(runs, ({ decisions }) => decisions), bill: billOf(kind, racer) },
    }
  })
}

const sum = (runs: readonly Run[], of: (run: Run) => number) => runs.reduce((all, run) => all + of(run), 0)

/** One row a lane and start: CSV with commas and points. */
export function csvOf({ shown }: Course, results: readonly LaneResult[]): string {
  const rows = results.flatMap(({ kind, runs }) =>
    (runs ?? []).map(({ score, cm, bumps, atWall, decisions }, start) =>
      [kind, start + 1, start < shown ? 0 : 1, score, cm, bumps, atWall, decisions].join(','),
    ),
  )
  return `${['lane,start,sealed,score,cm_a_minute,bumps,part_at_wall,decisions', ...rows].join('\n')}\n`
}
