import { missing } from '../parts/python.ts'
import { learningProgram } from '../parts/learning-examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'ai_q_draw_the_best_way'

/** Draws the way that was learned on the floor of the robot's world, and puts the robot on its start. */
export const ai_q_draw_the_best_way: Definition = {
  type,
  pack: 'learning',
  look: { category: 'q-learning', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: false,
  run: () => done,
  python: missing('draw'),
  example: learningProgram(),
}
