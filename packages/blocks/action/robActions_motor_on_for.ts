import { motorIn, timesNumber } from '../parts/python.ts'
import { type PythonAt } from '../python.ts'
import { number, start } from '../parts/examples.ts'
import { field, motorPortIn } from '../parts/fields.ts'
import { choice, motorPort, rows, value, worded, words } from '../parts/looks.ts'
import { ask, done, fail, wait } from '../parts/next.ts'
import { numberAt, percent } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motor_on_for'

/** VALUE in degrees: turns are 360 each. */
const degreesOf = (py: PythonAt) =>
  py.field('MOTORROTATION', 'ROTATIONS') === 'DEGREE'
    ? py.value('VALUE')
    : timesNumber(py.expression('VALUE'), 360)

/** VALUE turns (MOTORROTATION ROTATIONS) or degrees (DEGREE); the motor stops by itself and the next block comes then. */
export const robActions_motor_on_for: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [
      motorPort('B'),
      choice('MOTORROTATION', [worded('ROTATIONS', 'turns'), worded('DEGREE', 'degrees')]),
    ],
    inputs: [value('POWER', 'Number'), value('VALUE', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER'), ask('VALUE')], (frame, { robot }, block) => {
    const port = motorPortIn(block, 'MOTORPORT')
    if (port === undefined) return fail('unknownChoice')
    if (frame.counter === undefined) {
      frame.counter = 1
      const amount = numberAt(frame, 1)
      const degrees = field(block, 'MOTORROTATION', 'ROTATIONS') === 'DEGREE' ? amount : amount * 360
      const power = percent(numberAt(frame, 0))
      robot.turn(port, degrees < 0 ? 0 - power : power, Math.abs(degrees))
    }
    return robot.turned(port) ? done : wait
  }),
  python: (py) => py.line(py.robot.motorFor(motorIn(py), py.value('POWER'), degreesOf(py))),
  example: [
    start,
    {
      type,
      fields: { MOTORPORT: 'B', MOTORROTATION: 'ROTATIONS' },
      values: { POWER: number(30), VALUE: number(1) },
    },
  ],
}
