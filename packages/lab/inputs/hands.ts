import type { DriveKey, Hand, Wheels } from './input.ts'
import { setMotor, type Percent, type Simulation } from '@botgarten/simulation'

const FORWARD: Percent = 60
const TURN: Percent = 25

/** Wheel speeds for the arrow keys that are down. */
function wheelsOf(keys: readonly DriveKey[]): Wheels {
  const both = (down: DriveKey, up: DriveKey) => Number(keys.includes(down)) - Number(keys.includes(up))
  const ahead = both('up', 'down') * FORWARD
  const aside = both('right', 'left') * TURN
  return { left: ahead + aside, right: ahead - aside }
}

/** Who drives by hand now: the arrow keys, the pad. */
export interface Hands {
  readonly keys: readonly DriveKey[]
  /** Index of the robot that the keys drive. */
  readonly driven: number
  readonly hand: Hand | null
}

/** The wheels a hand holds of a robot; null where none is on. The pad goes before the keys. */
export function heldBy({ keys, driven, hand }: Hands, robot: number): Wheels | null {
  if (hand?.robot === robot) return { left: hand.left, right: hand.right }
  return keys.length > 0 && driven === robot ? wheelsOf(keys) : null
}

/**
 * Lets hands drive their robots for one tick: what the program has set comes back afterwards, a move that was under way
 * waits.
 */
export function withHands(simulation: Simulation, hands: Hands, tick: () => void): void {
  const after = simulation.state.robots.flatMap((_, index) => {
    const wheels = heldBy(hands, index)
    return wheels ? [takeWheels(simulation, index, wheels)] : []
  })
  tick()
  for (const giveBack of after) giveBack()
}

/** Sets the wheels of a robot. Returns how to set them back. */
function takeWheels(simulation: Simulation, index: number, wheels: Wheels): () => void {
  const robot = simulation.state.robots[index]!
  const { left, right } = simulation.world.robots[index]!.config.drive
  const before = { left: robot.motors[left].percent, right: robot.motors[right].percent }
  const { move } = robot
  const setWheels = (to: Wheels) => {
    robot.move = null
    setMotor(simulation, index, left, to.left)
    setMotor(simulation, index, right, to.right)
  }
  setWheels(wheels)
  return () => {
    setWheels(before)
    robot.move = move
  }
}
