import { readIn, compared } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { field, sensorPortIn } from '../parts/fields.ts'
import { choice, hidden, sensorPort, worded } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { holdsAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_ultrasonic_getSample'

/** So near (cm) is "something is there" (OR). */
const near = 30

/** MODE DISTANCE: to the next thing in cm, 0..255 · MODE PRESENCE: is anything nearer than 30 cm? */
export const robSensors_ultrasonic_getSample: Definition = {
  pack: 'core',
  ...sample(type, hidden('MODE', 'DISTANCE'), sensorPort('2')),
  expertLook: {
    fields: [
      choice('MODE', [worded('DISTANCE', 'distance'), worded('PRESENCE', 'presence')]),
      sensorPort('2'),
      hidden('SLOT'),
    ],
    faces: { by: { field: 'MODE' }, of: { DISTANCE: { output: 'Number' }, PRESENCE: { output: 'Boolean' } } },
    rows: [`expertLook.${type}.row0`],
  },
  check: sensorAtPort('ultrasonic', 'SENSORPORT'),
  run(block, _frame, context) {
    if (field(block, 'MODE', 'DISTANCE') === 'PRESENCE')
      return holdsAt(block, context, 'distance', (reading) => reading < near)
    const port = sensorPortIn(block, 'SENSORPORT')
    const reading = port === undefined ? null : context.robot.read(port, 'distance')
    return reading === null ? fail('nothingToRead') : give(reading)
  },
  python: (py) => {
    const distance = readIn(py, 'ultrasonic', 'distance')
    return py.field('MODE', 'DISTANCE') === 'PRESENCE' ? compared(distance.code, '<', String(near)) : distance
  },
  example: [start, forever(show(reading(type, 'DISTANCE', '2')))],
}
