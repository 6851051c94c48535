import { readIn } from '../parts/python.ts'
import { forever, lampIf, start } from '../parts/examples.ts'
import { hidden, sensorPort } from '../parts/looks.ts'
import { holdsAt, sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_touch_getSample'

/** Is the bumper pressed? */
export const robSensors_touch_getSample: Definition = {
  pack: 'core',
  ...sample(type, hidden('MODE', 'PRESSED'), sensorPort('1'), 'Boolean'),
  check: sensorAtPort('touch', 'SENSORPORT'),
  run: (block, _frame, context) => holdsAt(block, context, 'touch', (reading) => reading > 0),
  python: (py) => readIn(py, 'touch', 'pressed'),
  example: [start, forever(lampIf(reading(type, 'PRESSED', '1')))],
}
