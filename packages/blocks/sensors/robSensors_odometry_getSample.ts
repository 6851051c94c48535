import { forever, show, start } from '../parts/examples.ts'
import type { ReadMode } from '@botgarten/simulation'
import { field } from '../parts/fields.ts'
import { choice, hidden, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_odometry_getSample'
const modes: ReadonlyMap<string, ReadMode> = new Map([
  ['X', 'x'],
  ['Y', 'y'],
  ['THETA', 'heading'],
])

/** Where the robot is: MODE X and Y in cm from the bottom left corner, MODE THETA its heading in degrees. */
export const robSensors_odometry_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('MODE', [worded('X', 'x'), worded('Y', 'y'), worded('THETA', 'heading')]),
      sensorPort('4'),
      hidden('SLOT'),
    ],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('position', 'SENSORPORT'),
  run: (block, _frame, context) => readAt(block, context, modes.get(field(block, 'MODE', 'X')) ?? 'x'),
  example: [start, forever(show({ type, fields: { MODE: 'X', SENSORPORT: '4', SLOT: '' } }))],
}
