import type { LedColour } from '@botgarten/simulation'
import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, rows, worded, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'actions_bricklight_on_ev3'
const lamps: ReadonlyMap<string, LedColour> = new Map([
  ['GREEN', 'green'],
  ['ORANGE', 'orange'],
  ['RED', 'red'],
])

export const actions_bricklight_on_ev3: Definition = {
  type,
  look: {
    category: 'action',
    shape: 'statement',
    fields: [
      choice('COLOUR', [
        worded('GREEN', 'green', '#00642E'),
        worded('ORANGE', 'orange', '#F7D118'),
        worded('RED', 'red', '#B30006'),
      ]),
      hidden('MODE', 'ON'),
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const lamp = lamps.get(field(block, 'COLOUR', 'GREEN'))
    if (lamp === undefined) return fail('unknownChoice')
    robot.led(lamp)
    return done
  },
  example: [start, { type, fields: { COLOUR: 'GREEN', MODE: 'ON' } }],
}
