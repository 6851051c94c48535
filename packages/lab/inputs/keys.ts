import type { DriveKey } from '../types.ts'
import { setMotor, type Percent, type Simulation } from '@botgarten/simulation'

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
 * Lets the hand at the keys drive one robot for one tick: what the program has set comes back afterwards,
 * a move that was under way waits.
 */
export function withHandOnKeys(
  simulation: Simulation,
  index: number,
  keys: readonly DriveKey[],
  tick: () => void,
): void {
  const robot = simulation.state.robots[index]
  if (keys.length === 0 || !robot) return tick()
  const { left, right } = simulation.world.robots[index]!.config.drive
  const before = { left: robot.motors[left].percent, right: robot.motors[right].percent, move: robot.move }
  const wheels = driveBy(keys)
  const setWheels = (ofLeft: Percent, ofRight: Percent) => {
    robot.move = null
    setMotor(simulation, index, left, ofLeft)
    setMotor(simulation, index, right, ofRight)
  }
  setWheels(wheels.left, wheels.right)
  tick()
  setWheels(before.left, before.right)
  robot.move = before.move
}
