import { robSensors_infrared_getSample as plain } from '../sensors/robSensors_infrared_getSample.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, sensorPort, worded } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

/** MODE SEEK as well: direction and distance of a remote control; in our worlds there is none: 0 and −128. */
export const robSensors_infrared_getSample: Definition = {
  ...plain,
  look: {
    ...plain.look,
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
  run: (block, frame, context) =>
    field(block, 'MODE', 'DISTANCE') === 'SEEK' ? give([0, -128]) : plain.run(block, frame, context),
}
