import type { Dialect } from '@botgarten/programs/python'

const guides = {
  pybricks: 'to-the-robot',
  ev3dev2: 'to-the-robot-ev3dev',
  spike: 'to-the-robot-spike',
} as const

/** The guide in pictures to a robot, among the materials. */
export const guideOf = (dialect: Dialect): string => guides[dialect]
