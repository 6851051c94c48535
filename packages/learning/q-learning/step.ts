import { fast, isPlain } from './fast.ts'
import type { QLearner } from './learner.ts'
import { move } from './move.ts'
import type { QTrace } from './types.ts'

/** One move, opened. */
export function step(learner: QLearner): QTrace {
  const episode = learner.episodes + 1
  move(learner)
  return lastMove(learner, episode)
}

/** The last move that was made, opened. `episode`: the one that it belonged to. */
export function lastMove(learner: QLearner, episode: number): QTrace {
  const { last, world } = learner
  const [rho, nu] = last.draws as unknown as [number, number]
  const { from, teleported, move: taken, to, reward, before, bestNext, after, alpha, ends } = last
  return {
    ...{ t: learner.moves, episode, from, teleported, draws: { rho, nu }, move: taken, to },
    decision: taken < 0 ? null : last.explores ? 'explore' : 'exploit',
    meant: taken < 0 ? to : world.meant[taken]!,
    ...{ reward, before, bestNext, after, alpha, ends },
  }
}

/** Many moves, untraced: until so many moves or episodes are done. The same values as by steps, bit for bit. */
export function run(learner: QLearner, moves: number, episodes = Infinity): void {
  const untilMove = learner.moves + moves
  const untilEpisode = learner.episodes + episodes
  if (isPlain(learner)) fast(learner, untilMove, untilEpisode)
  while (learner.moves < untilMove && learner.episodes < untilEpisode) move(learner)
}
