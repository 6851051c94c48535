import { forever, show, start } from '../parts/examples.ts'
import { sensorPortIn } from '../parts/fields.ts'
import { hidden, rows, sensorPort, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_ultrasonic_getSample'

/** Distance to the next thing in cm, 0..255. */
export const robSensors_ultrasonic_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [hidden('MODE', 'DISTANCE'), sensorPort('2'), hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('ultrasonic', 'SENSORPORT'),
  run(block, _frame, { robot }) {
    const port = sensorPortIn(block, 'SENSORPORT')
    const reading = port === undefined ? null : robot.read(port, 'distance')
    return reading === null ? fail('nothingToRead') : give(reading)
  },
  example: [start, forever(show({ type, fields: { MODE: 'DISTANCE', SENSORPORT: '2', SLOT: '' } }))],
}
