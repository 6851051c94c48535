import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** The colour sensor of another maker; it reads like LEGO's. */
export const htcolour: Part = {
  type: 'robBrick_htcolour',
  is: { sensor: 'colour', maker: 'hitechnic' },
  fields: [],
  words: wordsOf('htcolour'),
  example: reading('htcolour', 'COLOUR'),
}
