import { fullTurn } from '../angles.ts'
import { meanColour } from '../floor/spot.ts'
import type { Scene } from '../scene.ts'
import type { Cm, Floor, Percent, RobotState, SensorPlace } from '../types.ts'
import { isBumped } from './bumper.ts'
import { distanceOf } from './cone.ts'
import { PORTS } from './noise.ts'

/** A sensor and what it reads: up to three numbers, see `sense`. */
export interface Sensor {
  readonly place: SensorPlace
  /** Directions of its rays from the robot: dx0, dy0, dx1, … The first is its axis. */
  readonly rays: Float64Array
  readonly values: Float64Array
  /** `Readings.moment` at which it was last read. */
  readAt: number
}

/** The farthest an ultrasonic and an infrared sensor see. */
const ULTRASONIC: Cm = 255
export const INFRARED: Cm = 70
/** At this distance a tone is half as loud. */
const HALF_LOUD: Cm = 20
const DEGREES = 180 / Math.PI

/** Where a sensor is and what it may look at. */
export interface Sight {
  readonly scene: Scene
  readonly floor: Floor
  readonly spot: Int32Array
}

/**
 * What a sensor reads at this moment goes into its values: ultrasonic cm · infrared 0..100 · colour red, green, blue ·
 * touch 0 or 1 · gyro angle, rate · sound 0..100 · compass degrees · position x, y, heading.
 */
export function sense(sight: Sight, robot: number, port: number, sensor: Sensor): void {
  const { scene } = sight
  const { place, rays, values } = sensor
  const factor = scene.noise.factors[robot * PORTS.length + port]!
  const own = scene.state.robots[robot]!
  switch (place.kind) {
    case 'ultrasonic':
      values[0] = Math.min(ULTRASONIC, distanceOf(scene.ground, robot, place, rays) * factor)
      break
    case 'infrared':
      values[0] = Math.min(100, (distanceOf(scene.ground, robot, place, rays) / INFRARED) * 100 * factor)
      break
    case 'colour':
      seeColour(sight, robot, place, values)
      for (let channel = 0; channel < 3; channel++) values[channel] = Math.min(255, values[channel]! * factor)
      break
    case 'touch':
      values[0] = Number(isBumped(scene.ground, robot, place, rays))
      break
    case 'gyro':
      values[0] = (own.gyroZero[PORTS[port]!] - own.heading) * DEGREES * factor
      values[1] = (0 - own.spin) * DEGREES * factor
      break
    case 'sound':
      values[0] = Math.min(100, loudness(scene, robot) * factor)
      break
    case 'compass':
      values[0] = fullTurn(90 - own.heading * DEGREES + shift(factor, 180))
      break
    case 'position':
      feelPlace(own, factor, values)
      break
    // It looks for a beacon, and no world has one.
    case 'irseeker':
      break
  }
}

/** Additive noise: at 1 ± noise of a reading that has no natural 0, so much of `whole`. */
const shift = (factor: number, whole: number) => (factor - 1) * whole

function feelPlace({ x, y, heading }: RobotState, factor: number, values: Float64Array): void {
  values[0] = x + shift(factor, 100)
  values[1] = y + shift(factor, 100)
  values[2] = fullTurn(heading * DEGREES + shift(factor, 180))
}

function seeColour({ scene, floor, spot }: Sight, robot: number, place: SensorPlace, values: Float64Array) {
  const { outlines } = scene.ground
  const c = outlines.cos[robot]!
  const s = outlines.sin[robot]!
  const x = outlines.x[robot]! + c * place.x - s * place.y
  const y = outlines.y[robot]! + s * place.x + c * place.y
  meanColour(floor, spot, x, y, values)
}

/** Of the loudest robot: its own tone is 100, another's falls with the distance between the two. */
function loudness({ state }: Scene, robot: number): Percent {
  const own = state.robots[robot]!
  let loudest = 0
  for (const other of state.robots) {
    if (other.tone === null) continue
    const dx = other.x - own.x
    const dy = other.y - own.y
    const away = Math.sqrt(dx * dx + dy * dy)
    loudest = Math.max(loudest, (100 * HALF_LOUD) / (HALF_LOUD + away))
  }
  return loudest
}
