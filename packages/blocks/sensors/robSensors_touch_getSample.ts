import { forever, lampIf, start } from '../parts/examples.ts'
import { hidden, rows, sensorPort, words } from '../parts/looks.ts'
import { holdsAt, sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_touch_getSample'

/** Is the bumper pressed? */
export const robSensors_touch_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Boolean',
    fields: [hidden('MODE', 'PRESSED'), sensorPort('1'), hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('touch', 'SENSORPORT'),
  run: (block, _frame, context) => holdsAt(block, context, 'touch', (reading) => reading > 0),
  example: [start, forever(lampIf({ type, fields: { MODE: 'PRESSED', SENSORPORT: '1', SLOT: '' } }))],
}
