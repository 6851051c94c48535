import type { FieldLook } from '../types.ts'
import { choice, worded } from './looks.ts'

/** Pictures of the display, by Open Roberta's names. */
export const pictureField: FieldLook = choice('PICTURE', [
  worded('EYESOPEN', 'eyesOpen'),
  worded('EYESCLOSED', 'eyesClosed'),
  worded('FLOWERS', 'flowers'),
  worded('OLDGLASSES', 'glasses'),
  worded('TACHO', 'tacho'),
])
