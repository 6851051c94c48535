import { assignAll } from './assign.ts'
import { distancesOf, flat } from './distances.ts'
import { moveAll } from './move.ts'
import { rowsOf } from './run.ts'
import type { Distance, KState, KTrace, Points } from './types.ts'

/** Nothing is sorted yet. */
export const startAt = (
  points: Points,
  centres: readonly (readonly number[])[],
  distance: Distance = 'euclidean',
): KState => ({
  ...{ distance, centres, before: centres, labels: Array.from({ length: points.count }, () => -1) },
  ...{ phase: 'assign', next: 0, changed: false, round: 0, inertia: [] },
})

export interface Stepped {
  readonly state: KState
  /** Null: it is done, nothing happens any more. */
  readonly trace: KTrace | null
}

/** The next operation: one point finds its nearest centre, or one centre moves. */
export function stepOne(points: Points, state: KState): Stepped {
  if (state.phase === 'done') return { state, trace: null }
  return state.phase === 'assign' ? assignOne(points, state) : moveOne(points, state)
}

/** What is left of this phase, at once: all points, or all centres. */
export function stepPhase(
  points: Points,
  state: KState,
): { readonly state: KState; readonly traces: readonly KTrace[] } {
  const traces: KTrace[] = []
  const { phase } = state
  let now = state
  while (now.phase === phase && phase !== 'done') {
    const stepped = stepOne(points, now)
    now = stepped.state
    if (stepped.trace) traces.push(stepped.trace)
  }
  return { state: now, traces }
}

function assignOne(points: Points, state: KState): Stepped {
  const { centres, distance, next: point, round } = state
  const distances = distancesOf(points, point, centres, distance)
  const label = distances.indexOf(Math.min(...distances))
  const before = state.labels[point]!
  const labels = state.labels.with(point, label)
  const changed = state.changed || label !== before
  const trace: KTrace = { kind: 'assign', round, point, distances, before, label }
  if (point + 1 < points.count) return { state: { ...state, labels, changed, next: point + 1 }, trace }
  const inertia = [...state.inertia, assignAll(points, flat(centres), distance, Int32Array.from(labels))]
  const done = { ...state, labels, changed: false, inertia, next: 0 }
  if (!changed) return { state: { ...done, phase: 'done', round: round + 1 }, trace }
  return { state: { ...done, phase: 'move' }, trace }
}

function moveOne(points: Points, state: KState): Stepped {
  const { before, centres, labels, distance, next: centre, round } = state
  const { centres: moved, takes } = moveAll(points, Int32Array.from(labels), flat(before), distance)
  const to = rowsOf(moved, points.features)[centre]!
  const trace: KTrace = {
    ...{ kind: 'move', round, centre, from: before[centre]!, to },
    takes: takes[centre]! < 0 ? null : takes[centre]!,
  }
  const now = centres.with(centre, to)
  if (centre + 1 < centres.length) return { state: { ...state, centres: now, next: centre + 1 }, trace }
  return { state: { ...state, centres: now, before: now, phase: 'assign', next: 0, round: round + 1 }, trace }
}
