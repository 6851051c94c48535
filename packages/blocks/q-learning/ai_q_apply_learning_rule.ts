import { learningProgram } from '../parts/learning-examples.ts'
import { rows, words } from '../parts/looks.ts'
import { mostEpisodes, mostMoves } from '../parts/maps.ts'
import { done } from '../parts/next.ts'
import type { Definition, FieldLook } from '../types.ts'

const type = 'ai_q_apply_learning_rule'

const limit = (name: string, preset: number, max: number): FieldLook => ({
  ...{ name, kind: 'number', preset, min: 1, max, step: 1 },
})

/** Learns until so many episodes or so many moves are over: a move is a second at ×1. */
export const ai_q_apply_learning_rule: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [limit('EPISODES', 100, mostEpisodes), limit('Q_LEARNER_TIME', 10_000, mostMoves)],
    inputs: [],
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  run: () => done,
  // What was learned stands at the head of the file.
  python(py) {
    if (py.learner)
      py.line(py.call('learn', py.field('EPISODES', '100'), py.field('Q_LEARNER_TIME', '10000')))
  },
  example: learningProgram(),
}
