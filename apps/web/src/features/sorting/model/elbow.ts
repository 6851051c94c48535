import { elbowOf, inertiaOfGroups } from '@botgarten/learning/k-means'
import { stream } from '@botgarten/numbers'
import { flagsFor, MOST_FLAGS, pointsIn, type Work } from './work.ts'

/** The sum of distances that is left with 1, 2, … flags, as far as it is computed. */
export interface FlagCurve {
  readonly inertia: readonly number[]
  /** Null while not all is computed, or if no number of flags stands out. */
  readonly elbow: number | null
}

/** A table of this many points is sorted from fewer starts. */
const MANY = 500

/** The curve, one number of flags a step. */
export function* flagCurve({
  table,
  distance,
}: Pick<Work, 'table' | 'distance'>): Generator<FlagCurve, void> {
  if (table.rows.length === 0 || table.columns.length === 0) return
  const most = flagsFor(MOST_FLAGS, table)
  const starts = table.rows.length > MANY ? 10 : 200
  const how = { starts, distance, stream: stream(1, 'learn/sorting/flags') }
  const inertia: number[] = []
  for (const value of inertiaOfGroups(pointsIn(table), most, how)) {
    inertia.push(value)
    yield { inertia: [...inertia], elbow: inertia.length === most ? elbowOf(inertia) : null }
  }
}
