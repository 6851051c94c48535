import { turn, wheels } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** Anything else that a motor port can power: a lamp, a fan, an older motor. */
export const actor: Part = {
  type: 'robBrick_actor',
  is: { motor: 'other' },
  fields: [],
  words: wordsOf('actor'),
  example: { plugged: { ...wheels(), MA: { type: 'robBrick_actor' } }, program: turn('A') },
}
