import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** Where north is. */
export const compass: Part = {
  type: 'robBrick_compass',
  is: { sensor: 'compass' },
  fields: [],
  words: wordsOf('compass', 'kind'),
  example: reading('compass', 'COMPASS'),
}
