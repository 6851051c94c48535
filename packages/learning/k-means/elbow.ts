import { ln, type StreamState } from '@botgarten/numbers'
import { bestOf } from './run.ts'
import type { Distance, Points } from './types.ts'

/** A share of the first sum: smaller ones count as alike. */
const ALIKE = 1e-9
/** Least bend of log inertia at an elbow. */
const CLEAR = 0.4

/** The inertia of the best of several starts for 1, 2, … groups, one number of groups a step. */
export function* inertiaOfGroups(
  points: Points,
  most: number,
  how: { readonly starts: number; readonly distance: Distance; readonly stream: StreamState },
): Generator<number, void> {
  let least = Infinity
  for (let groups = 1; groups <= Math.min(most, points.count); groups++) {
    // A further group can always stay empty: more groups are never worse.
    least = Math.min(least, bestOf(points, groups, { ...how, init: '++' }).inertia.at(-1)!)
    yield least
  }
}

/**
 * The elbow of a curve of inertia over 1, 2, … groups (Thorndike 1953): after it, a further group hardly helps. It is at the
 * largest bend of log inertia, so that each fall counts by its share. Null if no bend is clear.
 */
export function elbowOf(inertia: readonly number[]): number | null {
  const logs = inertia.map((value) => ln(Math.max(value, inertia[0]! * ALIKE)))
  let best: number | null = null
  let most = CLEAR
  for (let at = 1; at < logs.length - 1; at++) {
    const bend = logs[at - 1]! - 2 * logs[at]! + logs[at + 1]!
    if (bend > most) [most, best] = [bend, at + 1]
  }
  return best
}
