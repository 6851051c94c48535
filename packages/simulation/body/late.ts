import type { Late, MotorPort, RobotState } from '../types.ts'

export const MOTORS = ['A', 'B', 'C', 'D'] as const satisfies readonly MotorPort[]

/** How far each motor turns in a tick, in degrees. */
export type MotorTurns = { [port in MotorPort]: number }

/** What is on its way in a robot with delay; begun where nothing is yet. */
export const onItsWay = (robot: RobotState): Late => (robot.late ??= { turns: [], readings: [] })

/**
 * Sends off what the motors are told now, and hands out what they were told `delay` ticks ago. Rows stay twice as long
 * as that: when the last turn has left, what the sensors saw of it is still to come.
 */
export function lateTurns(robot: RobotState, delay: number, turns: MotorTurns): void {
  const { turns: sent } = onItsWay(robot)
  for (const port of MOTORS) sent.push(turns[port])
  const due = sent.length - (delay + 1) * MOTORS.length
  MOTORS.forEach((port, index) => (turns[port] = due >= 0 ? sent[due + index]! : 0))
  keepLast(sent, 2 * delay * MOTORS.length)
}

/** Forgets the oldest, so that at most so many numbers stay. */
export function keepLast(numbers: number[], most: number): void {
  if (numbers.length > most) numbers.splice(0, numbers.length - most)
}

/** Will it still turn, or see its turning, by what is on its way? */
export const rollsOn = (robot: RobotState): boolean => robot.late?.turns.some((turn) => turn !== 0) ?? false
