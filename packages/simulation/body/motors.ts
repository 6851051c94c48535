import type { MotorPort, RobotConfig, RobotState } from '../types.ts'
import { TICKS_PER_SECOND } from '../time.ts'

/** 100 percent is two wheel turns a second. */
const DEGREES_A_TICK_AT_FULL = (2 * 360) / TICKS_PER_SECOND

const PORTS = ['A', 'B', 'C', 'D'] as const satisfies readonly MotorPort[]

/** How far the two wheels turn in this tick, in degrees. */
export interface WheelTurns {
  left: number
  right: number
}

/**
 * Runs all motors of a robot for one tick: encoders go on, a move is used up. The last tick of a move is scaled so
 * that it ends where it should (running.md 4).
 */
export function runMotors(robot: RobotState, { drive }: RobotConfig, wheels: WheelTurns): void {
  const { motors, move } = robot
  const ticks = move ? ticksLeft(move, motors[drive.left].percent, motors[drive.right].percent) : Infinity
  const share = ticks <= LAST ? ticks : 1
  for (const port of PORTS) {
    const motor = motors[port]
    if (motor.percent === 0) continue
    const isWheel = port === drive.left || port === drive.right
    motor.turned += turnOf(motor.percent) * (isWheel ? share : 1)
  }
  wheels.left = turnOf(motors[drive.left].percent) * share
  wheels.right = turnOf(motors[drive.right].percent) * share
  if (!move) return
  if (ticks <= LAST) endMove(robot, drive)
  else useUp(move, wheels)
}

/** A move that needs this many ticks ends in this one; the hair above 1 takes up rounding. */
const LAST = 1 + 1e-9

const turnOf = (percent: number) => (percent / 100) * DEGREES_A_TICK_AT_FULL

/** How many ticks the move still needs, asked of the faster wheel. */
function ticksLeft(move: WheelTurns, left: number, right: number): number {
  const leftTurn = Math.abs(turnOf(left))
  const rightTurn = Math.abs(turnOf(right))
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
