import { part } from '../parts/python.ts'
import { learningProgram } from '../parts/learning-examples.ts'
import { hidden, rows, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition, FieldLook } from '../types.ts'

const type = 'ai_q_learner_config'

/** Words for the numbers that most need; an expert may set any other from 0 to 1. */
const setting = (
  name: string,
  preset: string,
  words: readonly (readonly [value: string, word: string])[],
): FieldLook => ({
  ...{ name, kind: 'choice', preset, numbers: { min: 0, max: 1 } },
  options: words.map(([value, word]) => worded(value, word)),
})

/**
 * How the robot learns: α, γ, ν and ρ of the learner as numbers; the words follow the numbers. ρ is the probability to
 * explore, so that using experience often means a small one. Hidden: how α and ρ fall ('', 'visits', or a factor an
 * episode) and the rule set.
 */
export const ai_q_learner_config: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    icon: 'gear',
    fields: [
      setting('ALPHA', '0.5', [
        ['0.1', 'slowly'],
        ['0.5', 'medium'],
        ['0.9', 'fast'],
      ]),
      setting('GAMMA', '0.8', [
        ['0.8', 'aLot'],
        ['0.2', 'aLittle'],
      ]),
      setting('NU', '0.1', [
        ['0.1', 'rarely'],
        ['0.9', 'often'],
      ]),
      setting('RHO', '0.5', [
        ['0.9', 'rarely'],
        ['0.5', 'sometimes'],
        ['0.1', 'often'],
      ]),
      hidden('ALPHA_DECAY'),
      hidden('RHO_DECAY'),
      hidden('RULES', 'standard'),
    ],
    inputs: [],
    // Two rows for the extra reward: in one its choice lay beyond the edge of the pane.
    rows: rows(type, 6),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: learningProgram(),
}
