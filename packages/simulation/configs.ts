import { FRONT } from './geometry/parts.ts'
import type { RobotConfig } from './types.ts'

const body = { wheelDiameter: 5.6, trackWidth: 18, drive: { left: 'C', right: 'B' } } as const

/** What the cards drive with: colour at port 1, ultrasonic at 2 (front left) and 3 (front right), turned ±20°. */
export const cardConfig: RobotConfig = {
  ...body,
  sensors: {
    '1': { kind: 'colour', x: 5, y: 0, angle: 0 },
    '2': { kind: 'ultrasonic', x: 10, y: 4, angle: 20 },
    '3': { kind: 'ultrasonic', x: 10, y: -4, angle: -20 },
  },
}

/** The robot as it comes out of the box, Open Roberta's: touch at port 1, gyro at 2, colour at 3, ultrasonic at 4. */
export const defaultConfig: RobotConfig = {
  ...body,
  sensors: {
    '1': { kind: 'touch', x: FRONT, y: 0, angle: 0 },
    '2': { kind: 'gyro', x: 0, y: 0, angle: 0 },
    '3': { kind: 'colour', x: 5, y: 0, angle: 0 },
    '4': { kind: 'ultrasonic', x: 10, y: 0, angle: 0 },
  },
}
