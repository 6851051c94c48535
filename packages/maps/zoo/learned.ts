import {
  courseStream,
  createLearner,
  greedyAction,
  run,
  type QLearner,
  type QWorld,
} from '@botgarten/learning/q-learning'
import type { MapFile } from '../types.ts'
import { outcomeOf, type Moves } from './behaviour.ts'
import { worldOf } from './task.ts'
import type { Cage, Outcome } from './types.ts'

/** What Bo has learned in a cage with its own setting. */
export interface Learned {
  readonly world: QWorld
  /** At each station one move. */
  readonly moves: Moves
  readonly outcome: Outcome
  /** Moves of all tries. */
  readonly steps: number
}

/** Learns with the cage's own setting: the same seed learns the same. */
export function learnIn(cage: Cage, map: Pick<MapFile, 'map'>, setting: number, seed: number): Learned {
  const { episodes, ...shares } = cage.setting
  const world = worldOf(cage, map, setting, shares.gamma)
  const settings = { rules: 'standard', algorithm: 'q', ...shares } as const
  const learner = createLearner(world, settings, courseStream(seed))
  run(learner, Infinity, episodes)
  const moves = greedyMoves(learner)
  return { world, moves, outcome: outcomeOf(world, moves, cage.wish), steps: learner.steps }
}

const greedyMoves = (learner: QLearner): Moves =>
  Array.from({ length: learner.world.states }, (_, state) => {
    const action = greedyAction(learner, state)
    return action < 0 ? [] : [learner.world.meant[action]!]
  })
