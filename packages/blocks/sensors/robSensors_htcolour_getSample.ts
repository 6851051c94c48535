import { colourFaces, colourModes } from '../parts/colour-modes.ts'
import { readColour } from '../parts/read-colour.ts'
import { forever, show, start } from '../parts/examples.ts'
import { hidden, rows, sensorPort, words } from '../parts/looks.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_htcolour_getSample'

/** The colour sensor of another maker: reads as robSensors_colour_getSample. */
export const robSensors_htcolour_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Colour',
    fields: [colourModes(false), sensorPort('1'), hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    faces: colourFaces(false),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: readColour,
  example: [start, forever(show({ type, fields: { MODE: 'COLOUR', SENSORPORT: '1', SLOT: '' } }))],
}
