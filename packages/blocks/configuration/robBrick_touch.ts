import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** Has the robot bumped into something? */
export const touch: Part = {
  type: 'robBrick_touch',
  is: { sensor: 'touch' },
  fields: [],
  words: wordsOf('touch', 'kind'),
  example: reading('touch', 'PRESSED'),
}
