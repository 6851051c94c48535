import type { Learner } from '../../learner.ts'
import { parameters } from './settings.ts'
import { beginPractice, restorePractice, savePractice } from './state.ts'
import { step } from './step.ts'
import type { Practice, PracticeData, SavedPractice, Settings, TrainTrace } from './types.ts'

/** A step is one example. Whole rounds at full speed: `finishThisRound`. */
export const net: Learner<Settings, PracticeData, Practice, SavedPractice, TrainTrace> = {
  name: 'net',
  parameters,
  begin: beginPractice,
  step,
  save: savePractice,
  restore: restorePractice,
}
