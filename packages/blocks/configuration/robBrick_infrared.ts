import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** How near something is, up to 70 cm. */
export const infrared: Part = {
  type: 'robBrick_infrared',
  is: { sensor: 'infrared' },
  fields: [],
  words: wordsOf('infrared', 'kind'),
  example: reading('infrared', 'DISTANCE'),
}
