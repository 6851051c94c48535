import { policy } from './greedy-path.ts'
import { doubtAt } from './learned.ts'
import type { QLearner } from './learner.ts'
import type { QWorld } from './world.ts'

/**
 * What a learner would do where actions are by chance: there is no way that it surely goes, but a action for every state
 * (a policy), which is judged by what it may expect.
 */
export interface Plan {
  /** By state the best action; −1: none. */
  readonly policy: readonly number[]
  /** The first state from which it may come to where the values tell no best action yet; null: it is learned. */
  readonly doubt: number | null
  /** Expected return from the start, and the largest that any policy has; null: without an end. */
  readonly expected: number | null
  readonly best: number | null
  /** Probability that it gets to the goal, without a limit of actions. */
  readonly reaches: number
}

/** Sweeps end when no value changes more than this. */
const EXACT = 1e-13
/** Values that still change after so many sweeps have no end. */
const MOST_SWEEPS = 100_000

/** An attempt ends at the goal, as in the standard rules; nothing explores and nothing teleports. */
export function planOf(learner: QLearner): Plan {
  const { world, settings } = learner
  const actions = policy(learner)
  const reached = reachedBy(world, actions)
  const doubt = reached.find((state) => doubtAt(learner, state) !== null) ?? null
  return {
    ...{ policy: actions, doubt, expected: expectedReturn(world, actions, settings.gamma) },
    best: bestReturn(world, settings.gamma),
    reaches: reachesGoal(world, actions),
  }
}

/** Expected return of a policy from the start. Iterative policy evaluation, Sutton & Barto, 4.1. */
export const expectedReturn = (world: QWorld, actions: readonly number[], gamma: number): number | null =>
  sweep(world, (worth, state) => {
    const action = actions[state]!
    return action < 0 ? 0 : valueOf(world, action, worth, gamma, rewardOf)
  })

/** The largest expected return from the start that any policy has. Value iteration, Sutton & Barto, 4.4. */
export const bestReturn = (world: QWorld, gamma: number): number | null =>
  sweep(world, (worth, state) => {
    const [from, end] = [world.first[state]!, world.first[state + 1]!]
    let best = from === end ? 0 : -Infinity
    for (let action = from; action < end; action++)
      best = Math.max(best, valueOf(world, action, worth, gamma, rewardOf))
    return best
  })

/** Probability that a policy gets from the start to the goal, without a limit of actions. */
export function reachesGoal(world: QWorld, actions: readonly number[]): number {
  const arrival = (end: number) => (world.isGoal[world.to[end]!]! === 1 ? 1 : 0)
  const terminal = world.terminal.map((ends, state) => (ends === 1 ? 1 : world.isGoal[state]!))
  const share = sweep({ ...world, terminal }, (worth, state) => {
    const action = actions[state]!
    return action < 0 ? 0 : valueOf(world, action, worth, 1, arrival)
  })
  return share ?? 0
}

/** What pays at an outcome of a action. */
type Pay = (end: number, world: QWorld) => number

const rewardOf: Pay = (end, { reward }) => reward[end]!

function valueOf(world: QWorld, action: number, worth: Float64Array, gamma: number, pay: Pay): number {
  const { outcome, to, upTo } = world
  let value = 0
  let before = 0
  for (let end = outcome[action]!; end < outcome[action + 1]!; end++) {
    value += (upTo[end]! - before) * (pay(end, world) + gamma * worth[to[end]!]!)
    before = upTo[end]!
  }
  return value
}

/** Works out what the start is worth: sweeps over all states until nothing changes; where an attempt ends it is 0. */
function sweep(
  { states, terminal, start }: QWorld,
  next: (worth: Float64Array, state: number) => number,
): number | null {
  const worth = new Float64Array(states)
  for (let count = 0; count < MOST_SWEEPS; count++) {
    let change = 0
    for (let state = 0; state < states; state++) {
      if (terminal[state] === 1) continue
      const value = next(worth, state)
      change = Math.max(change, Math.abs(value - worth[state]!) / Math.max(1, Math.abs(value)))
      worth[state] = value
    }
    if (!Number.isFinite(change)) return null
    if (change < EXACT) return worth[start]!
  }
  return null
}

/** States that a policy may come to from the start, ends left out, in the order they are reached. */
function reachedBy({ start, terminal, outcome, to }: QWorld, actions: readonly number[]): number[] {
  const seen = new Set(terminal[start] === 1 ? [] : [start])
  for (const state of seen) {
    const action = actions[state]!
    if (action < 0) continue
    for (let end = outcome[action]!; end < outcome[action + 1]!; end++)
      if (terminal[to[end]!] === 0) seen.add(to[end]!)
  }
  return [...seen]
}
