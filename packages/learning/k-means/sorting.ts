import { assignAll } from './assign.ts'
import { distancesOf, farIn, flat } from './distances.ts'
import { moveAll, type Moved } from './move.ts'
import { listOf, rowsOf } from './rows.ts'
import type { Distance, KState, KTrace, Points } from './types.ts'

/** A sorting at work, see KState. Its arrays and numbers are written by this file alone. */
export interface KSorting {
  readonly points: Points
  distance: Distance
  readonly centres: Float64Array
  readonly before: Float64Array
  readonly labels: Int32Array
  phase: KState['phase']
  next: number
  changed: boolean
  round: number
  inertia: number[]
  /** Where the centres belong in this round; null: not computed yet. It follows from the rest. */
  moved: Moved | null
}

/** Nothing is sorted yet. */
export const beginAt = (
  points: Points,
  centres: readonly (readonly number[])[],
  distance: Distance,
): KSorting => ({
  ...{ points, distance, centres: flat(centres), before: flat(centres) },
  labels: new Int32Array(points.count).fill(-1),
  ...{ phase: 'assign', next: 0, changed: false, round: 0, inertia: [], moved: null },
})

/** The next operation, in place: one point finds its nearest centre, or one centre moves. */
export function step(sorting: KSorting, trace?: (trace: KTrace) => void): void {
  if (sorting.phase === 'assign') assignOne(sorting, trace)
  else if (sorting.phase === 'move') moveOne(sorting, trace)
}

/** What is left of this phase, at once. The same as `step` until the phase changes. */
export function finishPhase(sorting: KSorting): void {
  const { points, centres, distance, labels } = sorting
  if (sorting.phase === 'assign') {
    const before = labels.slice()
    const inertia = assignAll(points, centres, distance, labels)
    sorting.changed ||= labels.some((label, point) => label !== before[point])
    endAssigning(sorting, inertia)
  } else if (sorting.phase === 'move') {
    centres.set(placesOf(sorting).centres)
    endMoving(sorting)
  }
}

function assignOne(sorting: KSorting, trace?: (trace: KTrace) => void): void {
  const { points, centres, distance, labels, next: point, round } = sorting
  const label = nearest(points, point, centres, distance)
  const before = labels[point]!
  if (trace) {
    const distances = distancesOf(points, point, rowsOf(centres, points.features), distance)
    trace({ kind: 'assign', round, point, distances, before, label })
  }
  labels[point] = label
  sorting.changed ||= label !== before
  sorting.next++
  if (sorting.next === points.count) endAssigning(sorting, assignAll(points, centres, distance, labels))
}

/** By the same numbers as `assignAll`: roots of two unequal squares can be equal. */
function nearest(
  { values, features }: Points,
  point: number,
  centres: Float64Array,
  distance: Distance,
): number {
  const far = farIn[distance]
  let best = 0
  let least = Infinity
  for (let from = 0; from < centres.length; from += features) {
    const away = far(values, point * features, centres, from, features)
    if (away < least) {
      least = away
      best = from
    }
  }
  return best / features
}

function endAssigning(sorting: KSorting, inertia: number): void {
  sorting.inertia.push(inertia)
  sorting.phase = sorting.changed ? 'move' : 'done'
  if (!sorting.changed) sorting.round++
  sorting.changed = false
  sorting.next = 0
}

function moveOne(sorting: KSorting, trace?: (trace: KTrace) => void): void {
  const { points, centres, before, next: centre, round } = sorting
  const { features } = points
  const { centres: places, takes } = placesOf(sorting)
  const from = centre * features
  for (let at = from; at < from + features; at++) centres[at] = places[at]!
  trace?.({
    ...{ kind: 'move', round, centre },
    from: [...before.subarray(from, from + features)],
    to: [...places.subarray(from, from + features)],
    takes: takes[centre]! < 0 ? null : takes[centre]!,
  })
  sorting.next++
  if (sorting.next * features === centres.length) endMoving(sorting)
}

const placesOf = (sorting: KSorting): Moved =>
  (sorting.moved ??= moveAll(sorting.points, sorting.labels, sorting.before, sorting.distance))

function endMoving(sorting: KSorting): void {
  sorting.before.set(sorting.centres)
  sorting.moved = null
  sorting.phase = 'assign'
  sorting.next = 0
  sorting.round++
}

export function save(sorting: KSorting): KState {
  const { points, distance, centres, before, labels, phase, next, changed, round, inertia } = sorting
  return {
    ...{ distance, phase, next, changed, round },
    centres: rowsOf(centres, points.features),
    before: rowsOf(before, points.features),
    labels: listOf(labels),
    inertia: [...inertia],
  }
}

/** @throws RangeError where the state does not fit these points and groups */
export function restore(sorting: KSorting, state: KState): void {
  refuseOther(sorting, state)
  sorting.centres.set(flat(state.centres))
  sorting.before.set(flat(state.before))
  sorting.labels.set(state.labels)
  const { distance, phase, next, changed, round, inertia } = state
  Object.assign(sorting, { distance, phase, next, changed, round, inertia: [...inertia], moved: null })
}

function refuseOther({ points, centres }: KSorting, state: KState): void {
  const groups = centres.length / points.features
  if (state.labels.length !== points.count)
    throw new RangeError(`This state knows ${state.labels.length} points, there are ${points.count}.`)
  for (const list of [state.centres, state.before])
    if (list.length !== groups || list.some(({ length }) => length !== points.features))
      throw new RangeError(`This state does not have ${groups} centres of ${points.features} numbers.`)
  if (state.labels.some((label) => !(label >= -1 && label < groups)))
    throw new RangeError('A point of this state is in a group that is not there.')
}
