import fc from 'fast-check'
import type { QWorld } from '../index.ts'
import type { Task } from '../types.ts'

/** Value iteration, Sutton & Barto, 2nd edition, 4.4, for Q: sweeps until nothing moves. By move. */
export function valueIteration(world: QWorld, gamma: number): number[] {
  const { first, outcome, to, reward, upTo, terminal, from } = world
  const q = Array.from(from, () => 0)
  const worth = (station: number) => {
    const own = q.slice(first[station], first[station + 1])
    return terminal[station] === 1 || own.length === 0 ? 0 : Math.max(...own)
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

/** Stations of a shortest way from start to goal; null: there is none. */
export function breadthFirst({ start, goal, first, meant }: QWorld): number | null {
  let reached = new Set([start])
  const seen = new Set(reached)
  for (let stations = 1; reached.size > 0; stations++) {
    if (reached.has(goal)) return stations
    const next = [...reached].flatMap((station) => [...meant.slice(first[station], first[station + 1])])
    reached = new Set(next.filter((station) => !seen.has(station)))
    for (const station of reached) seen.add(station)
  }
  return null
}

/** Graphs of 2 to 10 stations on which every station has a road to some other; start and goal differ. */
export const randomTask: fc.Arbitrary<Task> = fc
  .integer({ min: 2, max: 10 })
  .chain((stations) => {
    const station = fc.integer({ min: 0, max: stations - 1 })
    const roads = fc.uniqueArray(station, { minLength: 1, maxLength: 4 })
    return fc.record({
      moves: fc.array(roads, { minLength: stations, maxLength: stations }),
      start: station,
      goal: station,
    })
  })
  .filter(({ start, goal }) => start !== goal)
  .map(({ moves, start, goal }) => ({
    ...{ start, goal },
    map: { moves: moves.map((list, from) => list.filter((to) => to !== from).map((to) => ({ to }))) },
  }))
