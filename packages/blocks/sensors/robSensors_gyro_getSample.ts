import { readIn } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_gyro_getSample'

/** MODE ANGLE: degrees clockwise since it was set back · MODE RATE: degrees a second. */
export const robSensors_gyro_getSample: Definition = {
  pack: 'core',
  ...sample(type, choice('MODE', [worded('ANGLE', 'angle'), worded('RATE', 'rate')]), sensorPort('2')),
  check: sensorAtPort('gyro', 'SENSORPORT'),
  run: (block, _frame, context) =>
    readAt(block, context, field(block, 'MODE', 'ANGLE') === 'RATE' ? 'rate' : 'angle'),
  python: (py) => readIn(py, 'gyro', py.field('MODE', 'ANGLE') === 'RATE' ? 'rate' : 'angle'),
  example: [start, forever(show(reading(type, 'ANGLE', '2')))],
}
