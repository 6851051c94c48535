import type { DriveKey } from '../types.ts'
import {
  setMotor,
  type MotorPort,
  type Percent,
  type RobotState,
  type Simulation,
} from '@botgarten/simulation'

const FORWARD: Percent = 60
const TURN: Percent = 25

/** Wheel speeds for the arrow keys that are down. */
function driveBy(keys: readonly DriveKey[]): { left: Percent; right: Percent } {
  const both = (down: DriveKey, up: DriveKey) => Number(keys.includes(down)) - Number(keys.includes(up))
  const ahead = both('up', 'down') * FORWARD
  const aside = both('right', 'left') * TURN
  return { left: ahead + aside, right: ahead - aside }
}

/**
 * Lets the hand at the keys drive the first robot for one tick: what the program has set comes back afterwards,
 * a move that was under way waits.
 */
export function withHandOnKeys(simulation: Simulation, keys: readonly DriveKey[], tick: () => void): void {
  if (keys.length === 0) return tick()
  const robot = simulation.state.robots[0]!
  const { left, right } = simulation.world.robots[0]!.config.drive
  const before = { left: robot.motors[left].percent, right: robot.motors[right].percent, move: robot.move }
  const wheels = driveBy(keys)
  setWheels(simulation, robot, { left, right }, wheels.left, wheels.right)
  tick()
  setWheels(simulation, robot, { left, right }, before.left, before.right)
  robot.move = before.move
}

function setWheels(
  simulation: Simulation,
  robot: RobotState,
  ports: { left: MotorPort; right: MotorPort },
  left: Percent,
  right: Percent,
): void {
  robot.move = null
  setMotor(simulation, 0, ports.left, left)
  setMotor(simulation, 0, ports.right, right)
}
