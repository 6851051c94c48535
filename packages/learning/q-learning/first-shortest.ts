import { bestMove, bestWay } from './best-way.ts'
import type { QLearner } from './learner.ts'
import { move } from './move.ts'
import type { QWorld } from './world.ts'

/** Stations of a shortest way by sections, slippery moves as they are meant; null: there is none. Breadth first. */
export function shortestWay({ start, goal, first, meant, stations }: QWorld): number | null {
  const depth = new Int32Array(stations)
  depth[start] = 1
  const waiting = [start]
  for (const station of waiting) {
    if (station === goal) return depth[station]!
    for (let road = first[station]!; road < first[station + 1]!; road++) {
      const to = meant[road]!
      if (depth[to] !== 0) continue
      depth[to] = depth[station]! + 1
      waiting.push(to)
    }
  }
  return null
}

/**
 * Learns until so many moves or episodes are done. Returns the first move after which the best way was a shortest one,
 * counted from 1; null: none was. Looks only after moves that change what is best somewhere.
 */
export function learnWatching(learner: QLearner, moves: number, episodes = Infinity): number | null {
  const { world, tries, last } = learner
  const shortest = shortestWay(world)
  const lastMove = learner.moves + moves
  const lastEpisode = learner.episodes + episodes
  const best = Int32Array.from({ length: world.stations }, (_, station) => bestMove(learner, station))
  while (learner.moves < lastMove && learner.episodes < lastEpisode) {
    move(learner)
    if (last.move < 0) continue
    const now = bestMove(learner, last.from)
    if (now === best[last.from] && tries[last.move] !== 1) continue
    best[last.from] = now
    if (bestWay(learner).stations?.length === shortest) {
      const found = learner.moves
      while (learner.moves < lastMove && learner.episodes < lastEpisode) move(learner)
      return found
    }
  }
  return null
}
