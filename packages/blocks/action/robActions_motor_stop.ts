import { motorIn } from '../parts/python.ts'
import { start } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { choice, motorPort, rows, worded, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motor_stop'

/** MODE FLOAT rolls out, NONFLOAT brakes: here a wheel stops at once either way. */
export const robActions_motor_stop: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [motorPort('B'), choice('MODE', [worded('FLOAT', 'float'), worded('NONFLOAT', 'brake')])],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const port = motorPortIn(block, 'MOTORPORT')
    if (port === undefined) return fail('unknownChoice')
    robot.motor(port, 0)
    return done
  },
  python: (py) => py.line(py.robot.motorStop(motorIn(py), py.field('MODE', 'FLOAT') === 'FLOAT')),
  example: [start, { type, fields: { MOTORPORT: 'B', MODE: 'FLOAT' } }],
}
