import { start } from '../parts/examples.ts'
import { choice, hidden, rows, worded, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'actions_bricklight_off_ev3'

export const actions_bricklight_off_ev3: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [hidden('MODE', 'OFF')],
    inputs: [],
    rows: rows(type, 1),
  },
  // MODE RESET: off, too.
  expertLook: {
    fields: [choice('MODE', [worded('OFF', 'lampOff'), worded('RESET', 'lampReset')])],
    rows: [`expertLook.${type}.row0`],
  },
  words: words(type),
  acts: true,
  uses: 'lamp',
  run(_block, _frame, { robot }) {
    robot.led(null)
    return done
  },
  python: (py) => py.line(py.robot.lamp(null, 'ON')),
  example: [
    start,
    { type: 'actions_bricklight_on_ev3', fields: { COLOUR: 'RED', MODE: 'ON' } },
    { type, fields: { MODE: 'OFF' } },
  ],
}
