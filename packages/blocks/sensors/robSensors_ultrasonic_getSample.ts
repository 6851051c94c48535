import { forever, show, start } from '../parts/examples.ts'
import { sensorPortIn } from '../parts/fields.ts'
import { hidden, sensorPort } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_ultrasonic_getSample'

/** Distance to the next thing in cm, 0..255. */
export const robSensors_ultrasonic_getSample: Definition = {
  ...sample(type, hidden('MODE', 'DISTANCE'), sensorPort('2')),
  check: sensorAtPort('ultrasonic', 'SENSORPORT'),
  run(block, _frame, { robot }) {
    const port = sensorPortIn(block, 'SENSORPORT')
    const reading = port === undefined ? null : robot.read(port, 'distance')
    return reading === null ? fail('nothingToRead') : give(reading)
  },
  example: [start, forever(show(reading(type, 'DISTANCE', '2')))],
}
