import { forever, show, start } from '../parts/examples.ts'
import { readColour } from '../parts/read-colour.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_colour_getSample'

/** See `readColour`; the modes RGB, AMBIENTLIGHT and RED are on the block of the expert pack. */
export const robSensors_colour_getSample: Definition = {
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
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: readColour,
  example: [start, forever(show(reading(type, 'COLOUR', '1')))],
}
