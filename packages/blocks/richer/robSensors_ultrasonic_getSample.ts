import { robSensors_ultrasonic_getSample as plain } from '../sensors/robSensors_ultrasonic_getSample.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, sensorPort, worded } from '../parts/looks.ts'
import { holdsAt } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

/** So near (cm) is "something is there" (OR). */
const near = 30

/** MODE PRESENCE as well: is anything nearer than 30 cm? */
export const robSensors_ultrasonic_getSample: Definition = {
  ...plain,
  look: {
    ...plain.look,
    fields: [
      choice('MODE', [worded('DISTANCE', 'distance'), worded('PRESENCE', 'presence')]),
      sensorPort('2'),
      hidden('SLOT'),
    ],
    faces: { by: { field: 'MODE' }, of: { DISTANCE: { output: 'Number' }, PRESENCE: { output: 'Boolean' } } },
    rows: ['richer.robSensors_ultrasonic_getSample.row0'],
  },
  run: (block, frame, context) =>
    field(block, 'MODE', 'DISTANCE') === 'PRESENCE'
      ? holdsAt(block, context, 'distance', (reading) => reading < near)
      : plain.run(block, frame, context),
}
