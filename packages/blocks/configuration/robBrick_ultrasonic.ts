import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** How far something is, in cm. */
export const ultrasonic: Part = {
  type: 'robBrick_ultrasonic',
  is: { sensor: 'ultrasonic' },
  fields: [],
  words: wordsOf('ultrasonic', 'kind'),
  example: reading('ultrasonic', 'DISTANCE'),
}
