import { number, start } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { motorPort, rows, value, words } from '../parts/looks.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt, percent } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motor_setPower'

/** Another speed for a motor; it turns at it until it is set again. */
export const robActions_motor_setPower: Definition = {
  type,
  look: {
    category: 'action',
    shape: 'statement',
    fields: [motorPort('B')],
    inputs: [value('POWER', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER')], (frame, { robot }, block) => {
    const port = motorPortIn(block, 'MOTORPORT')
    if (port === undefined) return fail('unknownChoice')
    robot.motor(port, percent(numberAt(frame, 0)))
    return done
  }),
  example: [start, { type, fields: { MOTORPORT: 'B' }, values: { POWER: number(30) } }],
}
