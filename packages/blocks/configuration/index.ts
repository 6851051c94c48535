import { actor } from './robBrick_actor.ts'
import { colour } from './robBrick_colour.ts'
import { compass } from './robBrick_compass.ts'
import { brick } from './robBrick_EV3-Brick.ts'
import { gyro } from './robBrick_gyro.ts'
import { htcolour } from './robBrick_htcolour.ts'
import { infrared } from './robBrick_infrared.ts'
import { irseeker } from './robBrick_irseeker.ts'
import { motorBig } from './robBrick_motor_big.ts'
import { motorMiddle } from './robBrick_motor_middle.ts'
import { sound } from './robBrick_sound.ts'
import { touch } from './robBrick_touch.ts'
import { ultrasonic } from './robBrick_ultrasonic.ts'
import type { Part } from './part.ts'

export type { Part } from './part.ts'

/** Everything of Open Roberta's configuration toolbox, and the brick that it is plugged into. */
export const parts: readonly Part[] = [
  brick,
  ...[motorBig, motorMiddle, actor],
  ...[ultrasonic, colour, infrared, touch, gyro, sound, compass, irseeker, htcolour],
]

export const partOf = (type: string): Part | undefined => parts.find((part) => part.type === type)
