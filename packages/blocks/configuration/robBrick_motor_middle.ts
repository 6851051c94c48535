import { turn, wheels } from './examples.ts'
import { regulation, reverse } from './fields.ts'
import { wordsOf, type Part } from './part.ts'

/** Turns a claw or a lift; it drives no wheel. */
export const motorMiddle: Part = {
  type: 'robBrick_motor_middle',
  is: { motor: 'medium' },
  fields: [regulation, reverse],
  words: wordsOf('motor_middle'),
  example: {
    plugged: {
      ...wheels(),
      MA: { type: 'robBrick_motor_middle', fields: { MOTOR_REGULATION: 'TRUE', MOTOR_REVERSE: 'OFF' } },
    },
    program: turn('A'),
  },
}
