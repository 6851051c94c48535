import { cos, sin } from '@botgarten/numbers'
import type { Cm, Radians, RobotConfig } from '../types.ts'
import type { WheelTurns } from './motors.ts'

/** How a body is to move in a tick: by (x, y) on the floor, turning by `turn`. */
export interface Motion {
  x: Cm
  y: Cm
  turn: Radians
}

/**
 * The way of a robot whose wheels turn freely: along a circle round the instantaneous centre (running.md 4). The chord
 * points along the heading in the middle of the tick, so that nothing is lost by going in ticks.
 */
export function driveArc(config: RobotConfig, heading: Radians, wheels: WheelTurns, motion: Motion): void {
  const cmPerDegree = (config.wheelDiameter * Math.PI) / 360
  const half = ((wheels.right - wheels.left) * cmPerDegree) / config.trackWidth / 2
  const chord = ((wheels.left + wheels.right) / 2) * cmPerDegree * sinc(half)
  motion.turn = 2 * half
  motion.x = chord === 0 ? 0 : chord * cos(heading + half)
  motion.y = chord === 0 ? 0 : chord * sin(heading + half)
}

/** sin x / x. */
function sinc(x: number): number {
  if (x > 0.1 || x < -0.1) return sin(x) / x
  const z = x * x
  return 1 - (z / 6) * (1 - (z / 20) * (1 - (z / 42) * (1 - z / 72)))
}
