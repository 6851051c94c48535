import type { QWorld } from './world.ts'

/** Length of the action that a action takes, in the map's own unit. */
function lengthOfAction({ task, from, meant }: QWorld, action: number): number {
  return task.map.actions[from[action]!]!.find(({ to }) => to === meant[action])?.length ?? 0
}

/** Length of a way, in the map's own unit. @throws RangeError where a road of it is not there or closed */
export function lengthOf(world: QWorld, states: readonly number[]): number {
  return states.slice(1).reduce((sum, to, index) => {
    const from = states[index]!
    for (let action = world.first[from]!; action < world.first[from + 1]!; action++)
      if (world.leads[action] === to) return sum + lengthOfAction(world, action)
    throw new RangeError(`No open road leads from ${from} to ${to}.`)
  }, 0)
}

/** Length of the shortest way from start to goal, slippery moves as they are meant; null: there is none. Dijkstra 1959. */
export function shortestLength(world: QWorld): number | null {
  const { start, isGoal, first, leads, states } = world
  const lengths = new Float64Array(states).fill(Infinity)
  lengths[start] = 0
  const open = new Set(Array.from({ length: states }, (_, state) => state))
  while (open.size > 0) {
    const next = [...open].reduce((best, state) => (lengths[state]! < lengths[best]! ? state : best))
    if (lengths[next] === Infinity) return null
    if (isGoal[next] === 1) return lengths[next]!
    open.delete(next)
    for (let action = first[next]!; action < first[next + 1]!; action++) {
      const length = lengths[next]! + lengthOfAction(world, action)
      if (length < lengths[leads[action]!]!) lengths[leads[action]!] = length
    }
  }
  return null
}
