import { motorIn } from '../parts/python.ts'
import { show, start } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { motorPort, rows, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motor_getPower'

/** Percent. */
export const robActions_motor_getPower: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'value',
    output: 'Number',
    fields: [motorPort('B')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const port = motorPortIn(block, 'MOTORPORT')
    return port === undefined ? fail('unknownChoice') : give(robot.power(port))
  },
  python: (py) => py.robot.power(motorIn(py)),
  example: [start, show({ type, fields: { MOTORPORT: 'B' } })],
}
