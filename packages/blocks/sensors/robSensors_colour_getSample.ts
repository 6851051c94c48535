import { forever, show, start } from '../parts/examples.ts'
import { colourFaces, colourModes } from '../parts/colour-modes.ts'
import { pythonColour, readColour } from '../parts/read-colour.ts'
import { choice, hidden, sensorPort, worded } from '../parts/looks.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_colour_getSample'

/** See `readColour`; RED stands in old files alone. */
export const robSensors_colour_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    choice('MODE', [worded('COLOUR', 'colour'), worded('LIGHT', 'light')]),
    sensorPort('1'),
    'Colour',
    {
      by: { field: 'MODE' },
      of: { COLOUR: { output: 'Colour' }, LIGHT: { output: 'Number' } },
    },
  ),
  expertLook: {
    fields: [colourModes(true), sensorPort('1'), hidden('SLOT')],
    faces: colourFaces(true),
  },
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: readColour,
  python: pythonColour,
  example: [start, forever(show(reading(type, 'COLOUR', '1')))],
}
