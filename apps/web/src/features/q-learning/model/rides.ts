import { bestActions, policy, type Course, type QWorld } from '@botgarten/learning/q-learning'
import { draw, stream, type StreamState } from '@botgarten/numbers'

/** A ride by the learned values from the start. `lost`: off into an end that is no goal · `tired`: no end within the limit. */
export interface Ride {
  readonly states: readonly number[]
  readonly end: 'goal' | 'lost' | 'circle' | 'stuck' | 'tired'
}

/** Rides where moves are by chance, and moves that one of them has at most. */
export const RIDES = 10
const MOST = 100
/** How often a circle is shown. */
const ROUNDS = 3

/** The rides to watch: ten where moves are by chance, else one, as far as it is learned. */
export function ridesOf(course: Course, seed: number): readonly Ride[] {
  const { world } = course.learner
  if (!world.isSlippery) return [rideOf(course)]
  const actions = policy(course.learner)
  const dice = stream(seed, 'lab/rides')
  return Array.from({ length: RIDES }, () => slide(world, actions, dice))
}

function rideOf(course: Course): Ride {
  const way = course.way()
  if (way.states) return { states: way.states, end: 'goal' }
  const { walked } = way
  if (way.reason !== 'circle') return { states: walked, end: 'stuck' }
  const circle = walked.slice(walked.indexOf(walked.at(-1)!) + 1)
  return { states: [...walked, ...Array.from({ length: ROUNDS - 1 }, () => circle).flat()], end: 'circle' }
}

/** A ride whose moves may slip. */
function slide(world: QWorld, actions: readonly number[], dice: StreamState): Ride {
  const states = [world.start]
  for (let state = world.start; states.length <= MOST; states.push(state)) {
    if (world.isGoal[state] === 1) return { states, end: 'goal' }
    if (world.terminal[state] === 1) return { states, end: 'lost' }
    const action = actions[state]!
    if (action < 0) return { states, end: 'stuck' }
    state = outcomeOf(world, action, draw(dice))
  }
  return { states, end: 'tired' }
}

function outcomeOf({ outcome, upTo, to }: QWorld, action: number, die: number): number {
  let end = outcome[action]!
  while (die >= upTo[end]! && end < outcome[action + 1]! - 1) end += 1
  return to[end]!
}

/** The first station of a way with several moves of the same worth, and where they lead; null: there is none. */
export function tieOn(
  course: Course,
  way: readonly number[],
): { station: number; to: readonly number[] } | null {
  const { learner } = course
  for (const station of way.slice(0, -1)) {
    const best = bestActions(learner, station).filter((action) => learner.q[action]! > 0)
    if (best.length > 1) return { station, to: best.map((action) => learner.world.meant[action]!) }
  }
  return null
}
