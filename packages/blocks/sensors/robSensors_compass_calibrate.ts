import { missing } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { hidden, rows, sensorPort, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_compass_calibrate'

/** Our compass needs none: nothing happens. */
export const robSensors_compass_calibrate: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'sensors',
    shape: 'statement',
    fields: [sensorPort('1'), hidden('SLOT')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('compass', 'SENSORPORT'),
  run: () => done,
  python: missing('compass'),
  example: [start, { type, fields: { SENSORPORT: '1', SLOT: '' } }, show(number(1))],
}
