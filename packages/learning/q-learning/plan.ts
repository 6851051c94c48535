import { policy } from './best-way.ts'
import { doubtAt } from './learned.ts'
import type { QLearner } from './learner.ts'
import type { QWorld } from './world.ts'

/**
 * What a learner would do where moves are by chance: there is no way that it surely goes, but a move for every station
 * (a policy), which is judged by what it may expect.
 */
export interface Plan {
  /** By station the best move; −1: none. */
  readonly policy: readonly number[]
  /** The first station from which it may come to where the values tell no best move yet; null: it is learned. */
  readonly doubt: number | null
  /** Expected return from the start, and the largest that any policy has; null: without an end. */
  readonly expected: number | null
  readonly best: number | null
  /** Probability that it gets to the goal, without a limit of moves. */
  readonly reaches: number
}

/** Sweeps end when no value changes more than this. */
const EXACT = 1e-13
/** Values that still change after so many sweeps have no end. */
const MOST_SWEEPS = 100_000

/** An attempt ends at the goal, as in the standard rules; nothing explores and nothing teleports. */
export function planOf(learner: QLearner): Plan {
  const { world, settings } = learner
  const moves = policy(learner)
  const reached = reachedBy(world, moves)
  const doubt = reached.find((station) => doubtAt(learner, station) !== null) ?? null
  return {
    ...{ policy: moves, doubt, expected: expectedReturn(world, moves, settings.gamma) },
    best: bestReturn(world, settings.gamma),
    reaches: reachesGoal(world, moves),
  }
}

/** Expected return of a policy from the start. Iterative policy evaluation, Sutton & Barto, 4.1. */
export const expectedReturn = (world: QWorld, moves: readonly number[], gamma: number): number | null =>
  sweep(world, (worth, station) => {
    const move = moves[station]!
    return move < 0 ? 0 : valueOf(world, move, worth, gamma, rewardOf)
  })

/** The largest expected return from the start that any policy has. Value iteration, Sutton & Barto, 4.4. */
export const bestReturn = (world: QWorld, gamma: number): number | null =>
  sweep(world, (worth, station) => {
    const [from, end] = [world.first[station]!, world.first[station + 1]!]
    let best = from === end ? 0 : -Infinity
    for (let move = from; move < end; move++)
      best = Math.max(best, valueOf(world, move, worth, gamma, rewardOf))
    return best
  })

function reachesGoal(world: QWorld, moves: readonly number[]): number {
  const arrival = (end: number) => (world.to[end] === world.goal ? 1 : 0)
  const share = sweep(world, (worth, station) => {
    const move = moves[station]!
    return move < 0 ? 0 : valueOf(world, move, worth, 1, arrival)
  })
  return share ?? 0
}

/** What pays at an outcome of a move. */
type Pay = (end: number, world: QWorld) => number

const rewardOf: Pay = (end, { reward }) => reward[end]!

function valueOf(world: QWorld, move: number, worth: Float64Array, gamma: number, pay: Pay): number {
  const { outcome, to, upTo } = world
  let value = 0
  let before = 0
  for (let end = outcome[move]!; end < outcome[move + 1]!; end++) {
    value += (upTo[end]! - before) * (pay(end, world) + gamma * worth[to[end]!]!)
    before = upTo[end]!
  }
  return value
}

/** Works out what the start is worth: sweeps over all stations until nothing changes; where an attempt ends it is 0. */
function sweep(
  { stations, terminal, start }: QWorld,
  next: (worth: Float64Array, station: number) => number,
): number | null {
  const worth = new Float64Array(stations)
  for (let count = 0; count < MOST_SWEEPS; count++) {
    let change = 0
    for (let station = 0; station < stations; station++) {
      if (terminal[station] === 1) continue
      const value = next(worth, station)
      change = Math.max(change, Math.abs(value - worth[station]!) / Math.max(1, Math.abs(value)))
      worth[station] = value
    }
    if (!Number.isFinite(change)) return null
    if (change < EXACT) return worth[start]!
  }
  return null
}

/** Stations that a policy may come to from the start, ends left out, in the order they are reached. */
function reachedBy({ start, terminal, outcome, to }: QWorld, moves: readonly number[]): number[] {
  const seen = new Set(terminal[start] === 1 ? [] : [start])
  for (const station of seen) {
    const move = moves[station]!
    if (move < 0) continue
    for (let end = outcome[move]!; end < outcome[move + 1]!; end++)
      if (terminal[to[end]!] === 0) seen.add(to[end]!)
  }
  return [...seen]
}
