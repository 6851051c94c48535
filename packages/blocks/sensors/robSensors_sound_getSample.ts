import { readIn } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { hidden, sensorPort } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_sound_getSample'

/** How loud it is, 0..100. */
export const robSensors_sound_getSample: Definition = {
  pack: 'core',
  ...sample(type, hidden('MODE', 'SOUND'), sensorPort('2')),
  check: sensorAtPort('sound', 'SENSORPORT'),
  run: (block, _frame, context) => readAt(block, context, 'sound'),
  python: (py) => readIn(py, 'sound', 'sound'),
  example: [start, forever(show(reading(type, 'SOUND', '2')))],
}
