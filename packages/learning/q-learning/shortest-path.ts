import { greedyAction, greedyPath } from './greedy-path.ts'
import type { QLearner } from './learner.ts'
import { update } from './update.ts'
import type { QWorld } from './world.ts'

/** States of a shortest path by sections, slippery steps as they are meant; null: there is none. Breadth first. */
export function shortestPath({ start, isGoal, first, leads, states }: QWorld): number | null {
  const depth = new Int32Array(states)
  depth[start] = 1
  const waiting = [start]
  for (const state of waiting) {
    if (isGoal[state] === 1) return depth[state]!
    for (let action = first[state]!; action < first[state + 1]!; action++) {
      const to = leads[action]!
      if (depth[to] !== 0) continue
      depth[to] = depth[state]! + 1
      waiting.push(to)
    }
  }
  return null
}

/**
 * Learns until so many steps or episodes are done. Returns the first step after which the greedy path was a shortest one,
 * counted from 1; null: none was. Looks only after steps that change what is best somewhere.
 */
export function learnWatching(learner: QLearner, steps: number, episodes = Infinity): number | null {
  const { world, tries, last } = learner
  const shortest = shortestPath(world)
  const lastStep = learner.steps + steps
  const lastEpisode = learner.episodes + episodes
  const best = Int32Array.from({ length: world.states }, (_, state) => greedyAction(learner, state))
  while (learner.steps < lastStep && learner.episodes < lastEpisode) {
    update(learner)
    if (last.action < 0) continue
    const now = greedyAction(learner, last.from)
    if (now === best[last.from] && tries[last.action] !== 1) continue
    best[last.from] = now
    if (greedyPath(learner).states?.length === shortest) {
      const found = learner.steps
      while (learner.steps < lastStep && learner.episodes < lastEpisode) update(learner)
      return found
    }
  }
  return null
}
