import { forever, show, start } from '../parts/examples.ts'
import { hidden, rows, sensorPort, words } from '../parts/looks.ts'
import { readAt, sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_sound_getSample'

/** How loud it is, 0..100. */
export const robSensors_sound_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [hidden('MODE', 'SOUND'), sensorPort('2'), hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('sound', 'SENSORPORT'),
  run: (block, _frame, context) => readAt(block, context, 'sound'),
  example: [start, forever(show({ type, fields: { MODE: 'SOUND', SENSORPORT: '2', SLOT: '' } }))],
}
