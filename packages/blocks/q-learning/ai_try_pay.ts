import { part } from '../parts/python.ts'
import { choice, rows, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { tryProgram } from '../parts/trying-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_try_pay'

const what = choice('WHAT', [
  worded('BUMP', 'payBump'),
  worded('AHEAD', 'payAhead'),
  worded('MOMENT', 'payMoment'),
  worded('WAY', 'payWay'),
  worded('WHEELS', 'payWheels'),
  worded('FARTHER', 'payFarther'),
  worded('OPEN', 'payOpen'),
  worded('NEAR', 'payNear'),
  worded('TILE', 'payTile'),
  worded('BLACK', 'payBlack'),
  worded('LINE', 'payLine'),
  worded('FREE', 'payFree'),
])

/** One sentence of pay: so many coins each time, or for each unit of it. */
export const ai_try_pay: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [what, { name: 'COINS', kind: 'number', preset: -5, min: -20, max: 20 }],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: tryProgram(),
}
