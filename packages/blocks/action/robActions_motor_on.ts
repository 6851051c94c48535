import { motorSpeed } from '../parts/motor-speed.ts'

export const robActions_motor_on = motorSpeed('robActions_motor_on', 'core', 2)
