import { lampOn } from '../parts/lamps.ts'
import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_brickLight_on'

/** An old block; today actions_bricklight_on_ev3. */
export const robActions_brickLight_on: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [
      choice('SWITCH_COLOR', [
        worded('GREEN', 'green', '#00642E'),
        worded('ORANGE', 'orange', '#F7D118'),
        worded('RED', 'red', '#B30006'),
      ]),
      choice('SWITCH_BLINK', [
        worded('ON', 'lampOn'),
        worded('FLASH', 'flash'),
        worded('DOUBLE_FLASH', 'doubleFlash'),
      ]),
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'lamp',
  run: (block, _frame, { robot }) =>
    lampOn(robot, field(block, 'SWITCH_COLOR', 'GREEN'), field(block, 'SWITCH_BLINK', 'ON')),
  python: (py) => py.line(py.robot.lamp(py.field('SWITCH_COLOR', 'GREEN'), py.field('SWITCH_BLINK', 'ON'))),
  example: [start, { type, fields: { SWITCH_COLOR: 'GREEN', SWITCH_BLINK: 'ON' } }],
}
