import fc from 'fast-check'
import type { QWorld } from '../index.ts'
import type { Task } from '../types.ts'

/** Value iteration, Sutton & Barto, 2nd edition, 4.4, for Q: sweeps until nothing moves. By move. */
export function valueIteration(world: QWorld, gamma: number): number[] {
  const { first, outcome, to, reward, upTo, terminal, from } = world
  const q = Array.from(from, () => 0)
  const worth = (state: number) => {
    const own = q.slice(first[state], first[state + 1])
    return terminal[state] === 1 || own.length === 0 ? 0 : Math.max(...own)
  }
  for (let change = 1; change > 1e-14;) {
    change = 0
    for (let move = 0; move < q.length; move++) {
      let value = 0
      for (let end = outcome[move]!; end < outcome[move + 1]!; end++) {
        const odds = upTo[end]! - (end === outcome[move] ? 0 : upTo[end - 1]!)
        value += odds * (reward[end]! + gamma * worth(to[end]!))
      }
      change = Math.max(change, Math.abs(value - q[move]!))
      q[move] = value
    }
  }
  return q
}

/** States of a shortest way from start to goal; null: there is none. */
export function breadthFirst({ start, goal, first, meant }: QWorld): number | null {
  let reached = new Set([start])
  const seen = new Set(reached)
  for (let states = 1; reached.size > 0; states++) {
    if (reached.has(goal)) return states
    const next = [...reached].flatMap((state) => [...meant.slice(first[state], first[state + 1])])
    reached = new Set(next.filter((state) => !seen.has(state)))
    for (const state of reached) seen.add(state)
  }
  return null
}

/** Graphs of 2 to 10 states on which every state has a road to some other; start and goal differ. */
export const randomTask: fc.Arbitrary<Task> = fc
  .integer({ min: 2, max: 10 })
  .chain((states) => {
    const state = fc.integer({ min: 0, max: states - 1 })
    const roads = fc.uniqueArray(state, { minLength: 1, maxLength: 4 })
    return fc.record({
      actions: fc.array(roads, { minLength: states, maxLength: states }),
      start: state,
      goal: state,
    })
  })
  .filter(({ start, goal }) => start !== goal)
  .map(({ actions, start, goal }) => ({
    ...{ start, goal },
    map: { actions: actions.map((list, from) => list.filter((to) => to !== from).map((to) => ({ to }))) },
  }))
