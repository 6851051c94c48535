import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** How loud it is. */
export const sound: Part = {
  type: 'robBrick_sound',
  is: { sensor: 'sound' },
  fields: [],
  words: wordsOf('sound', 'kind'),
  example: reading('sound', 'SOUND'),
}
