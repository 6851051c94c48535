import type { Faces, FieldLook } from '../types.ts'
import { choice, worded } from './looks.ts'

/** RED: an old mode, reflected light. */
export const colourModes = (red: boolean): FieldLook =>
  choice('MODE', [
    worded('COLOUR', 'colour'),
    worded('LIGHT', 'light'),
    worded('AMBIENTLIGHT', 'ambientLight'),
    worded('RGB', 'rgb'),
    ...(red ? [worded('RED', 'redLight')] : []),
  ])

export const colourFaces = (red: boolean): Faces => ({
  by: { field: 'MODE' },
  of: {
    COLOUR: { output: 'Colour' },
    LIGHT: { output: 'Number' },
    AMBIENTLIGHT: { output: 'Number' },
    RGB: { output: 'Array_Number' },
    ...(red && { RED: { output: 'Number' } }),
  },
})
