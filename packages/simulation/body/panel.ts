import { TICKS_PER_SECOND } from '../time.ts'
import type { Degrees, MotorPort, RobotKey, SensorPort, Simulation } from '../types.ts'

// What a robot knows without a sensor at a port: its encoders, timers and the keys of its panel; and where its gyro's 0 is.

const robotOf = (sim: Simulation, robot: number) => sim.state.robots[robot]!

/** How far a motor has turned since Start or since it was set back. */
export const encoder = (sim: Simulation, robot: number, port: MotorPort): Degrees =>
  robotOf(sim, robot).motors[port].turned

export function resetEncoder(sim: Simulation, robot: number, port: MotorPort): void {
  robotOf(sim, robot).motors[port].turned = 0
}

/** Whole milliseconds on a timer, counted 1 to 5; null where there is none of this number. */
export function timer(sim: Simulation, robot: number, number: number): number | null {
  const ticks = robotOf(sim, robot).timers[number - 1]
  return ticks === undefined ? null : Math.round((ticks * 1000) / TICKS_PER_SECOND)
}

export function resetTimer(sim: Simulation, robot: number, number: number): void {
  const { timers } = robotOf(sim, robot)
  if (timers[number - 1] !== undefined) timers[number - 1] = 0
}

/** From now on the gyro at this port counts from here. */
export function resetGyro(sim: Simulation, robot: number, port: SensorPort): void {
  const state = robotOf(sim, robot)
  state.gyroZero[port] = state.heading
}

/** Presses a key of the panel, or lets it go. */
export function pressKey(sim: Simulation, robot: number, key: RobotKey, down: boolean): void {
  const state = robotOf(sim, robot)
  state.keys = state.keys.filter((pressed) => pressed !== key)
  if (down) state.keys.push(key)
}

export const isPressed = (sim: Simulation, robot: number, key: RobotKey | 'any'): boolean => {
  const { keys } = robotOf(sim, robot)
  return key === 'any' ? keys.length > 0 : keys.includes(key)
}
