import { drive, wheels } from './examples.ts'
import { drive as wheel, regulation, reverse } from './fields.ts'
import { wordsOf, type Part } from './part.ts'

/** Drives a wheel, or turns something else. Reversed at the left wheel, the robot drives the other way. */
export const motorBig: Part = {
  type: 'robBrick_motor_big',
  is: { motor: 'large' },
  fields: [regulation, reverse, wheel],
  words: wordsOf('motor_big'),
  example: { plugged: wheels('ON'), program: drive },
}
