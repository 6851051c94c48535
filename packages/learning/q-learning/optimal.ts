import type { QWorld } from './world.ts'

/** The best there is in a world: values of actions, and which actions are best in each state. */
export interface Optimum {
  /** Q*(s, a) by action. */
  readonly q: readonly number[]
  /** By state, all actions whose value is the largest, up to rounding; none where no action leaves it. */
  readonly best: readonly (readonly number[])[]
}

/** Values closer than this, beside the largest of all, are one. */
const ALIKE = 1e-9
/** Sweeps end when no value changes more than this, beside the largest of all. */
const EXACT = 1e-14
const MOST_SWEEPS = 10_000

/**
 * Value iteration, Sutton & Barto, 2nd edition, 4.4, by action. Without an end of an attempt but its goal and its holes.
 * @param gamma 0..1, less than 1 where an attempt need not end
 */
export function optimumOf(world: QWorld, gamma: number): Optimum {
  const q = new Float64Array(world.from.length)
  let largest = 1
  for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
    let change = 0
    for (let action = 0; action < q.length; action++) {
      const value = backedUp(world, q, action, gamma)
      change = Math.max(change, Math.abs(value - q[action]!))
      largest = Math.max(largest, Math.abs(value))
      q[action] = value
    }
    if (change < EXACT * largest) break
  }
  const best = Array.from({ length: world.states }, (_, state) => bestIn(world, q, state, ALIKE * largest))
  return { q: [...q], best }
}

function backedUp(world: QWorld, q: Float64Array, action: number, gamma: number): number {
  const { outcome, to, reward, upTo } = world
  let value = 0
  let before = 0
  for (let end = outcome[action]!; end < outcome[action + 1]!; end++) {
    value += (upTo[end]! - before) * (reward[end]! + gamma * worthOf(world, q, to[end]!))
    before = upTo[end]!
  }
  return value
}

function worthOf({ first, terminal }: QWorld, q: ArrayLike<number>, state: number): number {
  const [from, end] = [first[state]!, first[state + 1]!]
  if (terminal[state] === 1 || from === end) return 0
  let best = q[from]!
  for (let action = from + 1; action < end; action++) best = Math.max(best, q[action]!)
  return best
}

function bestIn({ first }: QWorld, q: Float64Array, state: number, alike: number): number[] {
  const actions = Array.from({ length: first[state + 1]! - first[state]! }, (_, k) => first[state]! + k)
  const most = actions.reduce((largest, action) => Math.max(largest, q[action]!), -Infinity)
  return actions.filter((action) => most - q[action]! <= alike)
}
