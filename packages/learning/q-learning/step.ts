import { fast, isPlain } from './fast.ts'
import type { Learner } from './learner.ts'
import { move } from './move.ts'
import type { QTrace } from './types.ts'

/** One move, opened. */
export function step(learner: Learner): QTrace {
  const episode = learner.episodes + 1
  move(learner)
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
export function run(learner: Learner, moves: number, episodes = Infinity): void {
  const lastMove = learner.moves + moves
  const lastEpisode = learner.episodes + episodes
  if (isPlain(learner)) fast(learner, lastMove, lastEpisode)
  while (learner.moves < lastMove && learner.episodes < lastEpisode) move(learner)
}
