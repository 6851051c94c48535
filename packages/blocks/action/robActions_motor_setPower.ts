import { motorSpeed } from '../parts/motor-speed.ts'

/** Another speed for a motor; it turns at it until it is set again. */
export const robActions_motor_setPower = motorSpeed('robActions_motor_setPower', 'expert', 1)
