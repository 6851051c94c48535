import { choice } from '../parts/looks.ts'

const option = (value: string, words: string) => ({ value, words: `robot.${words}` })

/** The program sets a speed that the motor keeps, or only a power. */
export const regulation = choice('MOTOR_REGULATION', [
  option('TRUE', 'regulated'),
  option('FALSE', 'unregulated'),
])
export const reverse = choice('MOTOR_REVERSE', [option('OFF', 'forwards'), option('ON', 'backwards')])
export const drive = choice('MOTOR_DRIVE', [
  option('NONE', 'noWheel'),
  option('LEFT', 'leftWheel'),
  option('RIGHT', 'rightWheel'),
])
