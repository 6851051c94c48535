import { fast, isPlain } from './fast.ts'
import type { QLearner } from './learner.ts'
import { update } from './update.ts'
import type { QTrace } from './types.ts'

/** One step with its trace. */
export function step(learner: QLearner): QTrace {
  const episode = learner.episodes + 1
  update(learner)
  return traceOfLast(learner, episode)
}

/** The trace of the last step. `episode`: the one that it belonged to. */
export function traceOfLast(learner: QLearner, episode: number): QTrace {
  const { last, world } = learner
  const [epsilon, nu] = last.draws as unknown as [number, number]
  const { from, teleported, action, to, reward, before, bestNext, after, alpha, ends } = last
  return {
    ...{ t: learner.steps, episode, from, teleported, draws: { epsilon, nu }, action, to },
    decision: action < 0 ? null : last.explores ? 'explore' : 'exploit',
    meant: action < 0 ? to : world.meant[action]!,
    ...{ reward, before, bestNext, after, alpha, ends },
  }
}

/** Many steps, untraced: until so many steps or episodes are done. The same values as by steps, bit for bit. */
export function run(learner: QLearner, steps: number, episodes = Infinity): void {
  const untilStep = learner.steps + steps
  const untilEpisode = learner.episodes + episodes
  if (isPlain(learner)) fast(learner, untilStep, untilEpisode)
  while (learner.steps < untilStep && learner.episodes < untilEpisode) update(learner)
}
