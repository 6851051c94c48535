import { robSensors_colour_getSample as plain } from '../sensors/robSensors_colour_getSample.ts'
import { colourFaces, colourModes } from '../parts/colour-modes.ts'
import { hidden, sensorPort } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

/** Modes AMBIENTLIGHT, RGB and (of old files) RED as well. */
export const robSensors_colour_getSample: Definition = {
  ...plain,
  look: {
    ...plain.look,
    fields: [colourModes(true), sensorPort('1'), hidden('SLOT')],
    faces: colourFaces(true),
  },
}
