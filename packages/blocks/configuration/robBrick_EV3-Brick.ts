import { drive, wheels } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** The brick: everything else is plugged into it, and it says how large the wheels are and how far apart. */
export const brick: Part = {
  type: 'robBrick_EV3-Brick',
  is: { brick: true },
  fields: [
    { name: 'WHEEL_DIAMETER', kind: 'number', preset: 5.6, min: 0.1, max: 100 },
    { name: 'TRACK_WIDTH', kind: 'number', preset: 18, min: 0.1, max: 100 },
  ],
  words: wordsOf('brick'),
  example: { plugged: wheels(), brick: { WHEEL_DIAMETER: '8', TRACK_WIDTH: '20' }, program: drive },
}
