import { draw, type StreamState } from '@botgarten/numbers'
import type { SensorPort, SimulationState, World } from '../types.ts'

export const PORTS = ['1', '2', '3', '4'] as const satisfies readonly SensorPort[]

/**
 * What sensors' readings are multiplied by in a tick. Every sensor of a noisy robot has one draw a tick, whether it is
 * read or not: robots in order, ports 1 to 4. `state.noise` stands before the draws of its tick, so that a restored
 * state reads the same; without noise nothing is drawn.
 */
export interface Noise {
  /** By robot and port: robot · 4 + port − 1. */
  readonly factors: Float64Array
  readonly isOn: boolean
  next: StreamState
}

export function createNoise(world: World): Noise {
  const isOn = world.robots.some(({ config }) => (config.noise ?? 0) > 0)
  return { factors: new Float64Array(world.robots.length * PORTS.length).fill(1), isOn, next: [0, 0, 0, 0] }
}

/** The factors of the tick that the state stands at. */
export function drawNoise(noise: Noise, world: World, state: SimulationState): void {
  if (!noise.isOn) return
  noise.next = [...state.noise] as StreamState
  world.robots.forEach(({ config }, robot) => {
    if (!((config.noise ?? 0) > 0)) return
    PORTS.forEach((port, index) => {
      if (!config.sensors[port]) return
      noise.factors[robot * PORTS.length + index] = 1 + ((2 * draw(noise.next) - 1) * config.noise!) / 100
    })
  })
}
