import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** Where an infrared light is: in our worlds there is none. */
export const irseeker: Part = {
  type: 'robBrick_irseeker',
  is: { sensor: 'irseeker' },
  fields: [],
  words: wordsOf('irseeker', 'kind'),
  example: reading('irseeker', 'MODULATED'),
}
