import { start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_brickLight_reset'

/** An old block; today actions_bricklight_off_ev3 with MODE RESET. */
export const robActions_brickLight_reset: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: { category: 'action', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  uses: 'lamp',
  run(_block, _frame, { robot }) {
    robot.led(null)
    return done
  },
  python: (py) => py.line(py.robot.lamp(null, 'ON')),
  example: [start, { type }],
}
