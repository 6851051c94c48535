import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** The colour of the floor below it. */
export const colour: Part = {
  type: 'robBrick_colour',
  is: { sensor: 'colour' },
  fields: [],
  words: wordsOf('colour', 'kind'),
  example: reading('colour', 'COLOUR'),
}
