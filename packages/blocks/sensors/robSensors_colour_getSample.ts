import { forever, show, start } from '../parts/examples.ts'
import { readColour } from '../parts/read-colour.ts'
import { choice, hidden, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_colour_getSample'

/** See `readColour`; the modes RGB, AMBIENTLIGHT and RED are on the block of the expert pack. */
export const robSensors_colour_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Colour',
    fields: [
      choice('MODE', [worded('COLOUR', 'colour'), worded('LIGHT', 'light')]),
      sensorPort('1'),
      hidden('SLOT'),
    ],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    faces: {
      by: { field: 'MODE' },
      of: { COLOUR: { output: 'Colour' }, LIGHT: { output: 'Number' } },
    },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: readColour,
  example: [start, forever(show({ type, fields: { MODE: 'COLOUR', SENSORPORT: '1', SLOT: '' } }))],
}
