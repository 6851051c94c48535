import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_gyro_getSample'

/** MODE ANGLE: degrees clockwise since it was set back · MODE RATE: degrees a second. */
export const robSensors_gyro_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('MODE', [worded('ANGLE', 'angle'), worded('RATE', 'rate')]),
      sensorPort('2'),
      hidden('SLOT'),
    ],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('gyro', 'SENSORPORT'),
  run: (block, _frame, context) =>
    readAt(block, context, field(block, 'MODE', 'ANGLE') === 'RATE' ? 'rate' : 'angle'),
  example: [start, forever(show({ type, fields: { MODE: 'ANGLE', SENSORPORT: '2', SLOT: '' } }))],
}
