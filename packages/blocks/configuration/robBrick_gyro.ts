import { reading } from './examples.ts'
import { wordsOf, type Part } from './part.ts'

/** How far the robot has turned. */
export const gyro: Part = {
  type: 'robBrick_gyro',
  is: { sensor: 'gyro' },
  fields: [],
  words: wordsOf('gyro', 'kind'),
  example: reading('gyro', 'ANGLE'),
}
