import { bestMove, bestWay, type BestWay } from './best-way.ts'
import type { QLearner } from './learner.ts'

/** Why the values of a station do not tell yet which of its roads is the best one. */
export type Doubt =
  /** None of its roads was tried. */
  | 'unknown'
  /** A road that was never tried is worth as much as the best one. */
  | 'untried'
  /** All of them are worth 0. */
  | 'alike'
  /** The best one was tried and is worth 0; others are worth less. */
  | 'unpaid'

/**
 * The best way where it has been learned; without one, the first reason on the way. A doubt is about the last station
 * that was walked to. `chance`: from there the best move leads here or there, so that there is no sure way (see plan.ts).
 */
export type LearnedWay =
  BestWay | { readonly stations: null; readonly reason: Doubt | 'chance'; readonly walked: readonly number[] }

/**
 * Do the values of a station tell which of its roads to take? They do where the best road was tried, is not worth
 * exactly 0, and no road that was never tried is worth as much. One road alone needs no values.
 */
export function doubtAt({ world: { first }, q, tries }: QLearner, station: number): Doubt | null {
  const [from, end] = [first[station]!, first[station + 1]!]
  if (end - from < 2) return null
  const values = q.subarray(from, end)
  const best = values.reduce((most, value) => Math.max(most, value), -Infinity)
  const counts = tries.subarray(from, end)
  if (counts.every((count) => count === 0)) return 'unknown'
  if (best === 0 && values.every((value) => value === 0)) return 'alike'
  if (counts.some((count, road) => count === 0 && values[road] === best)) return 'untried'
  return best === 0 ? 'unpaid' : null
}

/**
 * The best way, if it counts as learned. `bestWay` takes the first of equal roads, so that it may show a way where
 * nothing but their numbers has decided: after one try all roads of the start are still worth 0.
 */
export function learnedWay(learner: QLearner): LearnedWay {
  const way = bestWay(learner)
  if (way.reason === 'neverReached' || way.reason === 'startIsGoal') return way
  const walked = way.stations ?? way.walked
  for (const [index, station] of walked.entries()) {
    if (station === learner.world.goal) break
    const reason = doubtAt(learner, station) ?? (isByChance(learner, station) ? 'chance' : null)
    if (reason) return { stations: null, reason, walked: walked.slice(0, index + 1) }
  }
  return way
}

function isByChance(learner: QLearner, station: number): boolean {
  const { outcome } = learner.world
  const move = bestMove(learner, station)
  return move >= 0 && outcome[move + 1]! - outcome[move]! > 1
}
