import { motorIn } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { encoderPort, rows, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_encoder_reset'

/** The motor's encoder counts from 0 again. */
export const robSensors_encoder_reset: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'sensors',
    shape: 'statement',
    fields: [encoderPort('B')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const port = motorPortIn(block, 'SENSORPORT')
    if (port === undefined) return fail('unknownChoice')
    robot.resetEncoder(port)
    return done
  },
  python: (py) => py.line(py.robot.resetEncoder(motorIn(py, 'SENSORPORT'))),
  example: [
    start,
    { type, fields: { SENSORPORT: 'B' } },
    forever(
      show({
        type: 'robSensors_encoder_getSample',
        fields: { MODE: 'DEGREE', SENSORPORT: 'B', SLOT: '' },
      }),
    ),
  ],
}
