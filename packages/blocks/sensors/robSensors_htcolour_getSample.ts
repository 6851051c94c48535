import { missing } from '../parts/python.ts'
import { colourFaces, colourModes } from '../parts/colour-modes.ts'
import { readColour } from '../parts/read-colour.ts'
import { forever, show, start } from '../parts/examples.ts'
import { sensorPort } from '../parts/looks.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_htcolour_getSample'

/** The colour sensor of another maker: reads as robSensors_colour_getSample. */
export const robSensors_htcolour_getSample: Definition = {
  pack: 'expert',
  ...sample(type, colourModes(false), sensorPort('1'), 'Colour', colourFaces(false)),
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: readColour,
  python: missing('htcolour'),
  example: [start, forever(show(reading(type, 'COLOUR', '1')))],
}
