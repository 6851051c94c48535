import { readIn, compared } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, sensorPort, worded } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import { holdsAt, readAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_infrared_getSample'

/**
 * MODE DISTANCE: 0..100 over 70 cm · MODE PRESENCE: is anything within 70 cm? · MODE SEEK: direction and distance of a
 * remote control; in our worlds there is none: 0 and −128.
 */
export const robSensors_infrared_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    choice('MODE', [worded('DISTANCE', 'nearness'), worded('PRESENCE', 'presence')]),
    sensorPort('4'),
    'Number',
    {
      by: { field: 'MODE' },
      of: { DISTANCE: { output: 'Number' }, PRESENCE: { output: 'Boolean' } },
    },
  ),
  expertLook: {
    fields: [
      choice('MODE', [
        worded('DISTANCE', 'nearness'),
        worded('PRESENCE', 'presence'),
        worded('SEEK', 'seek'),
      ]),
      sensorPort('4'),
      hidden('SLOT'),
    ],
    faces: {
      by: { field: 'MODE' },
      of: {
        DISTANCE: { output: 'Number' },
        PRESENCE: { output: 'Boolean' },
        SEEK: { output: 'Array_Number' },
      },
    },
  },
  check: sensorAtPort('infrared', 'SENSORPORT'),
  run(block, _frame, context) {
    const mode = field(block, 'MODE', 'DISTANCE')
    if (mode === 'SEEK') return give([0, -128])
    return mode === 'PRESENCE'
      ? holdsAt(block, context, 'infrared', (reading) => reading < 100)
      : readAt(block, context, 'infrared')
  },
  python: (py) => {
    const mode = py.field('MODE', 'DISTANCE')
    if (mode === 'SEEK') return py.missing('beacon')
    const near = readIn(py, 'infrared', 'nearness')
    return mode === 'PRESENCE' ? compared(near.code, '<', '100') : near
  },
  example: [start, forever(show(reading(type, 'DISTANCE', '4')))],
}
