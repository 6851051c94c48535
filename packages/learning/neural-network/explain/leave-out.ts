import { weightsOf, withWeights } from '../edit.ts'
import type { Brain } from '../types.ts'

/** The same brain, deaf to one input: every link from it weighs 0, which is the same as an input of 0. `set`: '' for the knobs. */
export const leaveOut = (brain: Brain, input: string, set = ''): Brain =>
  withWeights(brain, { ...weightsOf(brain, set), [input]: {} }, set)
