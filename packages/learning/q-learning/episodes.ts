import { fast, isPlain } from './fast.ts'
import type { QLearner } from './learner.ts'
import { update } from './update.ts'

/** What the episodes of a learner were, by their number counted from 0. */
export interface EpisodeLog {
  readonly steps: Uint32Array
  /** Sum of what was paid, not discounted. */
  readonly rewards: Float64Array
  readonly falls: Uint32Array
}

/** An empty log of so many episodes. */
export const episodeLog = (episodes: number): EpisodeLog => ({
  steps: new Uint32Array(episodes),
  rewards: new Float64Array(episodes),
  falls: new Uint32Array(episodes),
})

/** So many whole episodes from where one begins, written down. The same steps as by `run`, bit for bit. */
export function runEpisodes(learner: QLearner, episodes: number, log: EpisodeLog): void {
  const last = learner.episodes + episodes
  if (isPlain(learner)) fast(learner, Infinity, last, log)
  while (learner.episodes < last) logEpisode(learner, log)
}

function logEpisode(learner: QLearner, { steps, rewards, falls }: EpisodeLog): void {
  const { last, episodes, steps: before } = learner
  let [gained, fallen] = [0, 0]
  while (learner.episodes === episodes) {
    update(learner)
    gained += last.reward
    if (last.fell) fallen++
  }
  steps[episodes] = learner.steps - before
  rewards[episodes] = gained
  falls[episodes] = fallen
}
