import type { QLearner } from './learner.ts'

/** The way that always takes the best action; without one, an honest reason. Stations are in the order walked. */
export type BestWay =
  | { readonly stations: readonly number[]; readonly reason: 'found' | 'startIsGoal' }
  | {
      readonly stations: null
      readonly reason: 'circle' | 'deadEnd' | 'unknown' | 'neverReached'
      /** How far it got; at a circle the last station is the one where it closes. */
      readonly walked: readonly number[]
    }

/** Of equally good moves the first: what is drawn must not change from look to look. */
export function bestMove({ world: { first }, q }: Pick<QLearner, 'world' | 'q'>, station: number): number {
  const end = first[station + 1]!
  let best = first[station]!
  if (best === end) return -1
  for (let move = best + 1; move < end; move++) if (q[move]! > q[best]!) best = move
  return best
}

/** By station the move it would take now; −1: there is none. */
export const policy = (learner: QLearner): number[] =>
  Array.from({ length: learner.world.stations }, (_, station) => bestMove(learner, station))

/** Walks the best way from start to goal, as far as it is known. Slippery moves are walked as they are meant. */
export function bestWay(learner: QLearner): BestWay {
  const { world, tries, goals } = learner
  const walked = [world.start]
  if (world.start === world.goal) return { stations: walked, reason: 'startIsGoal' }
  const none = (reason: 'circle' | 'deadEnd' | 'unknown') =>
    ({ stations: null, reason: goals === 0 ? 'neverReached' : reason, walked }) as const
  const seen = new Set(walked)
  for (let station = world.start; ;) {
    const move = bestMove(learner, station)
    if (move < 0) return none('deadEnd')
    if (tries[move] === 0) return none('unknown')
    station = world.meant[move]!
    walked.push(station)
    if (station === world.goal) return { stations: walked, reason: 'found' }
    if (seen.has(station)) return none('circle')
    seen.add(station)
  }
}
