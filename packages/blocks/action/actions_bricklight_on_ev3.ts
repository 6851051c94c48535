import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, rows, worded, words } from '../parts/looks.ts'
import { lampOn } from '../parts/lamps.ts'
import type { Definition } from '../types.ts'

const type = 'actions_bricklight_on_ev3'

const colour = choice('COLOUR', [
  worded('GREEN', 'green', '#00642E'),
  worded('ORANGE', 'orange', '#F7D118'),
  worded('RED', 'red', '#B30006'),
])

export const actions_bricklight_on_ev3: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [colour, hidden('MODE', 'ON')],
    inputs: [],
    rows: rows(type, 1),
  },
  expertLook: {
    fields: [
      colour,
      choice('MODE', [
        worded('ON', 'lampOn'),
        worded('FLASH', 'flash'),
        worded('DOUBLE_FLASH', 'doubleFlash'),
      ]),
    ],
    rows: [`expertLook.${type}.row0`],
  },
  words: words(type),
  acts: true,
  uses: 'lamp',
  run: (block, _frame, { robot }) =>
    lampOn(robot, field(block, 'COLOUR', 'GREEN'), field(block, 'MODE', 'ON')),
  python: (py) => py.line(py.robot.lamp(py.field('COLOUR', 'GREEN'), py.field('MODE', 'ON'))),
  example: [start, { type, fields: { COLOUR: 'GREEN', MODE: 'ON' } }],
}
