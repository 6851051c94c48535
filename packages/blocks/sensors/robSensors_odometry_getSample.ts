import { missing } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import type { ReadMode } from '@botgarten/simulation'
import { field } from '../parts/fields.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_odometry_getSample'
const modes: ReadonlyMap<string, ReadMode> = new Map([
  ['X', 'x'],
  ['Y', 'y'],
  ['THETA', 'heading'],
])

/** Where the robot is: MODE X and Y in cm from the bottom left corner, MODE THETA its heading in degrees. */
export const robSensors_odometry_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    choice('MODE', [worded('X', 'x'), worded('Y', 'y'), worded('THETA', 'heading')]),
    sensorPort('4'),
  ),
  check: sensorAtPort('position', 'SENSORPORT'),
  run: (block, _frame, context) => readAt(block, context, modes.get(field(block, 'MODE', 'X')) ?? 'x'),
  python: missing('position'),
  example: [start, forever(show(reading(type, 'X', '4')))],
}
