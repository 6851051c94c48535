import { along } from '../parts/python.ts'
import { speedsOf } from '../parts/driving.ts'
import { direction } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_curve'

/** Both wheels, each at its own speed. */
export const robActions_motorDiff_curve: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [direction('BACKWARD')],
    inputs: [value('POWER_LEFT', 'Number'), value('POWER_RIGHT', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER_LEFT'), ask('POWER_RIGHT')], (frame, { robot }, block) => {
    const { left, right } = speedsOf(frame, block)
    robot.move({ left, right })
    return done
  }),
  python: (py) => py.line(py.robot.drive(along(py, 'POWER_LEFT'), along(py, 'POWER_RIGHT'))),
  example: [
    start,
    { type, fields: { DIRECTION: 'FOREWARD' }, values: { POWER_LEFT: number(10), POWER_RIGHT: number(30) } },
  ],
}
