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

/** What is left of this phase, at once: all points, or all centres. The same as `stepOne` until the phase changes. */
export function stepPhase(points: Points, state: KState): KState {
  if (state.phase === 'done') return state
  return state.phase === 'assign' ? assignRest(points, state) : moveRest(points, state)
}

function assignOne(points: Points, state: KState): Stepped {
  const { centres, distance, next: point, round } = state
  const distances = distancesOf(points, point, centres, distance)
  const label = nearest(points, point, state)
  const before = state.labels[point]!
  const labels = state.labels.with(point, label)
  const changed = state.changed || label !== before
  const trace: KTrace = { kind: 'assign', round, point, distances, before, label }
  if (point + 1 < points.count) return { state: { ...state, labels, changed, next: point + 1 }, trace }
  return { state: assigned(points, { ...state, changed }), trace }
}

/** By the same numbers as all at once: roots of two unequal squares can be equal. */
function nearest({ values, features }: Points, point: number, { centres, distance }: KState): number {
  const alone = values.subarray(point * features, (point + 1) * features)
  const label = new Int32Array(1)
  assignAll({ values: alone, count: 1, features }, flat(centres), distance, label)
  return label[0]!
}

function assignRest(points: Points, state: KState): KState {
  const found = new Int32Array(points.count)
  assignAll(points, flat(state.centres), state.distance, found)
  return assigned(points, {
    ...state,
    changed: state.changed || state.labels.some((label, point) => label !== found[point]),
  })
}

/** All points have found their centres. */
function assigned(points: Points, state: KState): KState {
  const found = new Int32Array(points.count)
  const inertia = [...state.inertia, assignAll(points, flat(state.centres), state.distance, found)]
  const done = { ...state, labels: [...found], changed: false, inertia, next: 0 }
  return state.changed ? { ...done, phase: 'move' } : { ...done, phase: 'done', round: state.round + 1 }
}

function moveOne(points: Points, state: KState): Stepped {
  const { before, centres, labels, distance, next: centre, round } = state
  const { centres: places, takes } = moveAll(points, Int32Array.from(labels), flat(before), distance)
  const to = rowsOf(places, points.features)[centre]!
  const trace: KTrace = {
    ...{ kind: 'move', round, centre, from: before[centre]!, to },
    takes: takes[centre]! < 0 ? null : takes[centre]!,
  }
  const now = centres.with(centre, to)
  if (centre + 1 < centres.length) return { state: { ...state, centres: now, next: centre + 1 }, trace }
  return { state: moved(state, now), trace }
}

function moveRest(points: Points, state: KState): KState {
  const { centres } = moveAll(points, Int32Array.from(state.labels), flat(state.before), state.distance)
  return moved(state, rowsOf(centres, points.features))
}

/** All centres have moved: the round is over. */
const moved = (state: KState, centres: readonly (readonly number[])[]): KState => ({
  ...state,
  ...{ centres, before: centres, phase: 'assign', next: 0, round: state.round + 1 },
})
