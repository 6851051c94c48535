import { forever, show, start } from '../parts/examples.ts'
import { sensorPortIn } from '../parts/fields.ts'
import { rows, sensorPort, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_gyro_reset'

/** The gyro's angle is 0 here. */
export const robSensors_gyro_reset: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'sensors',
    shape: 'statement',
    fields: [sensorPort('2')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('gyro', 'SENSORPORT'),
  run(block, _frame, { robot }) {
    const port = sensorPortIn(block, 'SENSORPORT')
    if (port === undefined || robot.read(port, 'angle') === null) return fail('nothingToRead')
    robot.resetGyro(port)
    return done
  },
  python: (py) =>
    py.line(py.robot.resetGyro(sensorPortIn(py.block, 'SENSORPORT') ?? py.gap('problem.unknownChoice'))),
  example: [
    start,
    { type, fields: { SENSORPORT: '2' } },
    forever(
      show({ type: 'robSensors_gyro_getSample', fields: { MODE: 'ANGLE', SENSORPORT: '2', SLOT: '' } }),
    ),
  ],
}
