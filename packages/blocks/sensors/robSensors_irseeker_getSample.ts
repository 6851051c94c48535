import { show, start } from '../parts/examples.ts'
import { choice, hidden, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_irseeker_getSample'

/** Direction of an infrared light, 1 to 9, 5 straight ahead; 0: there is none. In our worlds there is none. */
export const robSensors_irseeker_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('MODE', [worded('MODULATED', 'modulated'), worded('UNMODULATED', 'unmodulated')]),
      sensorPort('1'),
      hidden('SLOT'),
    ],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: () => give(0),
  example: [start, show({ type, fields: { MODE: 'MODULATED', SENSORPORT: '1', SLOT: '' } })],
}
