import { part } from '../parts/python.ts'
import { choice, hidden, rows, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { tryProgram } from '../parts/trying-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_try_actions'

const chips = [
  worded('AHEAD', 'tryAhead'),
  worded('LEFT', 'tryLeft'),
  worded('RIGHT', 'tryRight'),
  worded('BACK', 'tryBack'),
  worded('STOP', 'tryStop'),
  worded('NONE', 'tryNone'),
]
const chip = (number: number, preset: string) => choice(`CHIP${number}`, chips, preset)

/** What a robot that tries can do. HOLD: for how many ticks it does so. */
export const ai_try_actions: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [chip(1, 'AHEAD'), chip(2, 'LEFT'), chip(3, 'RIGHT'), chip(4, 'NONE'), hidden('HOLD', '15')],
    inputs: [],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: tryProgram(),
}
