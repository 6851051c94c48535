import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { holdsAt, readAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_infrared_getSample'

/** MODE DISTANCE: 0..100 over 70 cm · MODE PRESENCE: is anything within 70 cm? */
export const robSensors_infrared_getSample: Definition = {
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
  check: sensorAtPort('infrared', 'SENSORPORT'),
  run: (block, _frame, context) =>
    field(block, 'MODE', 'DISTANCE') === 'PRESENCE'
      ? holdsAt(block, context, 'infrared', (reading) => reading < 100)
      : readAt(block, context, 'infrared'),
  example: [start, forever(show(reading(type, 'DISTANCE', '4')))],
}
