import { forever, show, start } from '../parts/examples.ts'
import { field, sensorPortIn } from '../parts/fields.ts'
import { choice, hidden, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_colour_getSample'

/** MODE COLOUR: one of the eight colours as `#RRGGBB` · MODE LIGHT: brightness of the floor, 0..100. */
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
  run(block, _frame, { robot }) {
    const port = sensorPortIn(block, 'SENSORPORT')
    const mode = field(block, 'MODE', 'COLOUR') === 'LIGHT' ? 'light' : 'colour'
    const reading = port === undefined ? null : robot.read(port, mode)
    return reading === null ? fail('nothingToRead') : give(reading)
  },
  example: [start, forever(show({ type, fields: { MODE: 'COLOUR', SENSORPORT: '1', SLOT: '' } }))],
}
