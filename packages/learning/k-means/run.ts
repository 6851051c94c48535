import type { StreamState } from '@botgarten/numbers'
import { flat } from './distances.ts'
import { LARGEST } from './points.ts'
import { roundsOver } from './round.ts'
import { listOf, rowsOf } from './rows.ts'
import { plusPlusStart, randomStart } from './starts.ts'
import type { Clustering, Distance, Points } from './types.ts'

const MOST_ROUNDS = 300

/**
 * Lloyd's algorithm (Lloyd 1982) from these centres until no point changes its group; at most 300 rounds. Rounds are
 * counted as scikit-learn's `n_iter_` counts them: the last one, in which nothing changes, too.
 */
export function cluster(
  points: Points,
  start: readonly (readonly number[])[],
  distance: Distance = 'euclidean',
): Clustering {
  refuse(points, start)
  let centres = flat(start)
  const rounds = roundsOver(points, start.length, distance)
  const inertia: number[] = []
  for (let changed = true; changed && inertia.length < MOST_ROUNDS;) {
    const done = rounds.next(centres)
    inertia.push(done.inertia)
    changed = done.changed
    if (changed) centres = done.centres
  }
  return {
    centres: rowsOf(centres, points.features),
    labels: listOf(rounds.labels()),
    inertia,
    iterations: inertia.length,
  }
}

/** The best of several starts: the smallest inertia at the end, of equal ones the first; with that start. */
export function bestOf(
  points: Points,
  groups: number,
  options: {
    readonly starts: number
    readonly init: 'random' | '++'
    readonly distance: Distance
    readonly stream: StreamState
  },
): Clustering & { readonly start: readonly (readonly number[])[] } {
  const { starts, init, distance, stream } = options
  let best: ReturnType<typeof bestOf> | null = null
  for (let index = 0; index < starts; index++) {
    const start =
      init === '++' ? plusPlusStart(points, groups, distance, stream) : randomStart(points, groups, stream)
    const found = cluster(points, start, distance)
    if (best === null || found.inertia.at(-1)! < best.inertia.at(-1)!) best = { ...found, start }
  }
  if (best === null) throw new RangeError('One start is the least.')
  return best
}

function refuse({ count, features }: Points, start: readonly (readonly number[])[]): void {
  if (start.length < 1) throw new RangeError('There are 0 groups; one is the least.')
  if (start.length > count)
    throw new RangeError(`${start.length} groups need as many points; there are ${count}.`)
  for (const centre of start) {
    if (centre.length !== features || !centre.every(Number.isFinite))
      throw new RangeError(`A centre has ${features} numbers, as the points have.`)
    if (centre.some((value) => Math.abs(value) > LARGEST))
      throw new RangeError(`A centre is farther out than ${LARGEST}, which is the most.`)
  }
}
