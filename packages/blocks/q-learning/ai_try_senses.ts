import { part } from '../parts/python.ts'
import { choice, rows, sensorPort, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { tryProgram } from '../parts/trying-examples.ts'
import type { Definition, FieldLook } from '../types.ts'

const type = 'ai_try_senses'

const edge = (name: string, preset: number): FieldLook => ({
  ...{ name, kind: 'number', preset, min: 0, max: 100, step: 1 },
})

/** One sensor of those whose buckets are the states: below LOW, between, from HIGH on. Colours and touch are buckets themselves. */
export const ai_try_senses: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [
      choice('SENSE', [
        worded('DISTANCE', 'trySeesDistance'),
        worded('LIGHT', 'trySeesLight'),
        worded('COLOUR', 'trySeesColour'),
        worded('TOUCH', 'tryFeelsTouch'),
      ]),
      sensorPort('2'),
      edge('LOW', 15),
      edge('HIGH', 40),
    ],
    inputs: [],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: tryProgram(),
}
