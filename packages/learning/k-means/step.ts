import { beginAt, finishPhase, restore, save, step, type KSorting } from './sorting.ts'
import type { Distance, KState, KTrace, Points } from './types.ts'

// A screen that leads back keeps every state: each operation makes a new one.

/** Nothing is sorted yet. */
export const startAt = (
  points: Points,
  centres: readonly (readonly number[])[],
  distance: Distance = 'euclidean',
): KState => save(beginAt(points, centres, distance))

export interface Stepped {
  readonly state: KState
  /** Null: it is done, nothing happens any more. */
  readonly trace: KTrace | null
}

/** The next operation: one point finds its nearest centre, or one centre moves. */
export function stepOne(points: Points, state: KState): Stepped {
  const sorting = resumed(points, state)
  let trace: KTrace | null = null
  step(sorting, (made) => (trace = made))
  return { state: save(sorting), trace }
}

/** What is left of this phase, at once: all points, or all centres. The same as `stepOne` until the phase changes. */
export function stepPhase(points: Points, state: KState): KState {
  const sorting = resumed(points, state)
  finishPhase(sorting)
  return save(sorting)
}

function resumed(points: Points, state: KState): KSorting {
  const sorting = beginAt(points, state.centres, state.distance)
  restore(sorting, state)
  return sorting
}
