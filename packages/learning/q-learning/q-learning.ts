import type { Learner } from '../learner.ts'
import { createLearner, restoreLearner, saveLearner, type QLearner } from './learner.ts'
import { update } from './update.ts'
import { parameters } from './settings.ts'
import { traceOfLast } from './step.ts'
import type { QState, QTrace, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** A step is one step. Many steps without a trace: `run`, which is faster and the same. */
export const qLearning: Learner<Settings, QWorld, QLearner, QState, QTrace> = {
  name: 'q',
  parameters,
  begin: (settings, world, stream) => createLearner(world, settings, stream),
  step(learner, trace) {
    const episode = learner.episodes + 1
    update(learner)
    trace?.(traceOfLast(learner, episode))
  },
  save: saveLearner,
  restore: restoreLearner,
}
