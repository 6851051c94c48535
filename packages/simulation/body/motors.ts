import type { RobotConfig, RobotState } from '../types.ts'
import { TICKS_PER_SECOND } from '../time.ts'
import { lateTurns, MOTORS, type MotorTurns } from './late.ts'

/** 100 percent is two wheel turns a second. */
const DEGREES_A_TICK_AT_FULL = (2 * 360) / TICKS_PER_SECOND

/** How far the two wheels turn in this tick, in degrees. */
export interface WheelTurns {
  left: number
  right: number
}

const turns: MotorTurns = { A: 0, B: 0, C: 0, D: 0 }
const told: WheelTurns = { left: 0, right: 0 }

/**
 * Runs all motors of a robot for one tick: encoders go on, a move is used up. The last tick of a move is scaled so
 * that it ends where it should (running.md 4). With delay, what is ordered now turns the motors some ticks later.
 */
export function runMotors(robot: RobotState, config: RobotConfig, wheels: WheelTurns): void {
  const { drive, delay = 0 } = config
  order(robot, config)
  if (delay > 0) lateTurns(robot, delay, turns)
  else robot.late = null
  for (const port of MOTORS) robot.motors[port].turned += turns[port]
  wheels.left = turns[drive.left]
  wheels.right = turns[drive.right]
}

/** What the motors are told in this tick goes into `turns`. */
function order(robot: RobotState, { drive, strength }: RobotConfig): void {
  const { motors, move } = robot
  told.left = turnOf(motors[drive.left].percent) * (strength?.left ?? 1)
  told.right = turnOf(motors[drive.right].percent) * (strength?.right ?? 1)
  const ticks = move ? ticksLeft(move, told) : Infinity
  const share = ticks <= LAST ? ticks : 1
  for (const port of MOTORS) turns[port] = turnOf(motors[port].percent)
  turns[drive.left] = told.left * share
  turns[drive.right] = told.right * share
  for (const port of MOTORS) endTurn(motors[port], port)
  if (!move) return
  if (ticks <= LAST) endMove(robot, drive)
  else useUp(move, told)
}

/** A motor that turns a certain way turns no farther: its last tick is scaled. */
function endTurn(motor: RobotState['motors']['A'], port: 'A' | 'B' | 'C' | 'D'): void {
  if (motor.left === null) return
  const way = Math.abs(turns[port])
  if (way * LAST < motor.left) {
    motor.left -= way
    return
  }
  if (way > 0) turns[port] *= motor.left / way
  motor.left = null
  motor.percent = 0
}

/** A move that needs this many ticks ends in this one; the hair above 1 takes up rounding. */
const LAST = 1 + 1e-9

const turnOf = (percent: number) => (percent / 100) * DEGREES_A_TICK_AT_FULL

/** How many ticks the move still needs, asked of the faster wheel. */
function ticksLeft(move: WheelTurns, { left, right }: WheelTurns): number {
  const leftTurn = Math.abs(left)
  const rightTurn = Math.abs(right)
  return leftTurn > rightTurn ? move.left / leftTurn : move.right / rightTurn
}

function useUp(move: WheelTurns, wheels: WheelTurns): void {
  move.left -= Math.abs(wheels.left)
  move.right -= Math.abs(wheels.right)
}

function endMove(robot: RobotState, drive: RobotConfig['drive']): void {
  robot.move = null
  robot.motors[drive.left].percent = 0
  robot.motors[drive.right].percent = 0
}
