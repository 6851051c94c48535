import { part } from '../parts/python.ts'
import { learningProgram, obstacles } from '../parts/learning-examples.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition, FieldLook } from '../types.ts'

const type = 'ai_q_barrier_mountain'

const station = (name: string, preset: number): FieldLook => ({
  ...{ name, kind: 'number', preset, min: 0, max: 499, step: 1 },
})

/** Closes the road from one station to the next, in this direction alone. */
export const ai_q_barrier_mountain: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'value',
    output: 'Obstacle',
    fields: [station('FROM', 2), station('TO', 3)],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => give(0),
  python: part,
  example: learningProgram(obstacles([[3, 2]])), // prettier-ignore
}
