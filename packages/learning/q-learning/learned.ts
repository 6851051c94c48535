import { greedyAction, greedyPath, type GreedyPath } from './greedy-path.ts'
import type { QLearner } from './learner.ts'

/** Why the values of a state do not tell yet which of its actions is the best one. */
export type Doubt =
  /** None of its actions was tried. */
  | 'unknown'
  /** A action that was never tried is worth as much as the best one. */
  | 'untried'
  /** All of them are worth 0. */
  | 'alike'
  /** The best one was tried and is worth 0; others are worth less. */
  | 'unpaid'

/**
 * The best way where it has been learned; without one, the first reason on the way. A doubt is about the last state
 * that was walked to. `chance`: from there the best action leads here or there, so that there is no sure way (see plan.ts).
 */
export type LearnedPath =
  | GreedyPath
  | { readonly states: null; readonly reason: Doubt | 'chance'; readonly walked: readonly number[] }

/**
 * Do the values of a state tell which of its actions to take? They do where the best action was tried, is not worth
 * exactly 0, and no action that was never tried is worth as much. One action alone needs no values.
 */
export function doubtAt({ world: { first }, q, tries }: QLearner, state: number): Doubt | null {
  const [from, end] = [first[state]!, first[state + 1]!]
  if (end - from < 2) return null
  const values = q.subarray(from, end)
  const best = values.reduce((most, value) => Math.max(most, value), -Infinity)
  const counts = tries.subarray(from, end)
  if (counts.every((count) => count === 0)) return 'unknown'
  if (best === 0 && values.every((value) => value === 0)) return 'alike'
  if (counts.some((count, action) => count === 0 && values[action] === best)) return 'untried'
  return best === 0 ? 'unpaid' : null
}

/**
 * The best way, if it counts as learned. `greedyPath` takes the first of equal actions, so that it may show a way where
 * nothing but their numbers has decided: after one try all actions of the start are still worth 0. If the first of equal
 * actions leads into a circle and another one to the goal, the way to the goal is learned.
 */
export function learnedPath(learner: QLearner): LearnedPath {
  const first = greedyPath(learner)
  if (first.reason === 'neverReached' || first.reason === 'startIsGoal') return first
  const way = first.states === null && !learner.world.isSlippery ? (tiedPath(learner) ?? first) : first
  const walked = way.states ?? way.walked
  for (const [index, state] of walked.entries()) {
    if (learner.world.isGoal[state] === 1) break
    const reason = doubtAt(learner, state) ?? (isByChance(learner, state) ? 'chance' : null)
    if (reason) return { states: null, reason, walked: walked.slice(0, index + 1) }
  }
  return way
}

function isByChance(learner: QLearner, state: number): boolean {
  const { outcome } = learner.world
  const action = greedyAction(learner, state)
  return action >= 0 && outcome[action + 1]! - outcome[action]! > 1
}

/** The actions of a state that are worth as much as its best one and were tried. */
export function bestActions({ world: { first }, q, tries }: QLearner, state: number): readonly number[] {
  const all = Array.from({ length: first[state + 1]! - first[state]! }, (_, k) => first[state]! + k)
  const most = all.reduce((best, action) => Math.max(best, q[action]!), -Infinity)
  return all.filter((action) => q[action] === most && tries[action]! > 0)
}

/** The shortest path to a goal by actions that are all among the best of their state; null if no such path exists. */
function tiedPath(learner: QLearner): GreedyPath | null {
  const { start, leads, isGoal } = learner.world
  const before = new Map<number, number | null>([[start, null]])
  for (const state of before.keys()) {
    if (isGoal[state] === 1) return { states: pathTo(state, before), reason: 'found' }
    for (const action of bestActions(learner, state)) {
      const to = leads[action]!
      if (!before.has(to)) before.set(to, state)
    }
  }
  return null
}

function pathTo(goal: number, before: ReadonlyMap<number, number | null>): readonly number[] {
  const path: number[] = []
  for (let state: number | null = goal; state !== null; state = before.get(state)!) path.unshift(state)
  return path
}
