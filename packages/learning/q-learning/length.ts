import type { QWorld } from './world.ts'

/** Length of the road that a move takes, in the map's own unit. */
function lengthOfMove({ task, from, meant }: QWorld, move: number): number {
  return task.map.moves[from[move]!]!.find(({ to }) => to === meant[move])?.length ?? 0
}

/** Length of a way, in the map's own unit. @throws RangeError where a road of it is not there or closed */
export function lengthOf(world: QWorld, stations: readonly number[]): number {
  return stations.slice(1).reduce((sum, to, index) => {
    const from = stations[index]!
    for (let move = world.first[from]!; move < world.first[from + 1]!; move++)
      if (world.meant[move] === to) return sum + lengthOfMove(world, move)
    throw new RangeError(`No open road leads from ${from} to ${to}.`)
  }, 0)
}

/** Length of the shortest way from start to goal, slippery moves as they are meant; null: there is none. Dijkstra 1959. */
export function shortestLength(world: QWorld): number | null {
  const { start, goal, first, meant, stations } = world
  const lengths = new Float64Array(stations).fill(Infinity)
  lengths[start] = 0
  const open = new Set(Array.from({ length: stations }, (_, station) => station))
  while (open.size > 0) {
    const next = [...open].reduce((best, station) => (lengths[station]! < lengths[best]! ? station : best))
    if (lengths[next] === Infinity) return null
    if (next === goal) return lengths[goal]!
    open.delete(next)
    for (let move = first[next]!; move < first[next + 1]!; move++) {
      const length = lengths[next]! + lengthOfMove(world, move)
      if (length < lengths[meant[move]!]!) lengths[meant[move]!] = length
    }
  }
  return null
}
