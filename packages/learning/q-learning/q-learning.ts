import type { Learner } from '../learner.ts'
import { createLearner, restoreLearner, saveLearner, type QLearner } from './learner.ts'
import { move } from './move.ts'
import { parameters } from './settings.ts'
import { lastMove } from './step.ts'
import type { QState, QTrace, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** A step is one move. Many moves without a trace: `run`, which is faster and the same. */
export const qLearning: Learner<Settings, QWorld, QLearner, QState, QTrace> = {
  name: 'q',
  parameters,
  begin: (settings, world, stream) => createLearner(world, settings, stream),
  step(learner, trace) {
    const episode = learner.episodes + 1
    move(learner)
    trace?.(lastMove(learner, episode))
  },
  save: saveLearner,
  restore: restoreLearner,
}
