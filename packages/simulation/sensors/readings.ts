import { cos, sin } from '@botgarten/numbers'
import { radiansOf } from '../angles.ts'
import { colourOf } from '../floor/colours.ts'
import { meanColour, spotOf } from '../floor/spot.ts'
import type { Scene } from '../scene.ts'
import type { Colour, Floor, Ray, ReadMode, SensorPlace, SensorPort } from '../types.ts'
import { castCone, CONE, distanceOf } from './cone.ts'
import { PORTS } from './noise.ts'

/** A sensor and what it has read since the world last changed. */
interface Sensor {
  readonly place: SensorPlace
  /** Directions of its rays from the robot: dx0, dy0, dx1, … */
  readonly rays: Float64Array
  readonly mean: Float64Array
  distance: number
  /** `Readings.moment` at which it was last read. */
  readAt: number
}

/** Readings are worked out when somebody asks, and kept until the world changes. */
export interface Readings {
  readonly floor: Floor
  readonly spot: Int32Array
  readonly sensors: readonly (Sensor | null)[]
  moment: number
}

export function createReadings(scene: Scene, floor: Floor): Readings {
  const sensors = scene.world.robots.flatMap(({ config }) =>
    PORTS.map((port) => (config.sensors[port] ? sensorAt(config.sensors[port]) : null)),
  )
  return { floor, spot: spotOf(floor), sensors, moment: 0 }
}

function sensorAt(place: SensorPlace): Sensor {
  const angles = CONE.map((offset) => radiansOf(place.angle) + offset)
  const rays = Float64Array.from(angles.flatMap((angle) => [cos(angle), sin(angle)]))
  return { place, rays, mean: new Float64Array(3), distance: 0, readAt: -1 }
}

/** See `Simulation.read`. */
export function read(
  scene: Scene,
  readings: Readings,
  robot: number,
  port: SensorPort,
  mode: ReadMode,
): number | Colour | null {
  const slot = robot * PORTS.length + port.charCodeAt(0) - 49
  const sensor = readings.sensors[slot]
  if (!sensor || (mode === 'distance') !== (sensor.place.kind === 'ultrasonic')) return null
  if (sensor.readAt !== readings.moment) renew(scene, readings, robot, slot)
  switch (mode) {
    case 'distance':
      return sensor.distance
    case 'light':
      return ((sensor.mean[0]! + sensor.mean[1]! + sensor.mean[2]!) / 3 / 255) * 100
    case 'colour':
      return colourOf(sensor.mean[0]!, sensor.mean[1]!, sensor.mean[2]!)
    case 'red':
      return sensor.mean[0]!
    case 'green':
      return sensor.mean[1]!
    case 'blue':
      return sensor.mean[2]!
  }
}

function renew(scene: Scene, readings: Readings, robot: number, slot: number): void {
  const { place, rays, mean } = readings.sensors[slot]!
  const factor = scene.noise.factors[slot]!
  const sensor = readings.sensors[slot]!
  const { outlines } = scene.ground
  if (place.kind === 'ultrasonic') {
    sensor.distance = Math.min(255, distanceOf(scene.ground, robot, place, rays) * factor)
  } else {
    const c = outlines.cos[robot]!
    const s = outlines.sin[robot]!
    const x = outlines.x[robot]! + c * place.x - s * place.y
    const y = outlines.y[robot]! + s * place.x + c * place.y
    meanColour(readings.floor, readings.spot, x, y, mean)
    for (let channel = 0; channel < 3; channel++) mean[channel] = Math.min(255, mean[channel]! * factor)
  }
  sensor.readAt = readings.moment
}

/** See `Simulation.rays`. */
export function raysOf(scene: Scene, readings: Readings, robot: number, port: SensorPort): readonly Ray[] {
  const sensor = readings.sensors[robot * PORTS.length + port.charCodeAt(0) - 49]
  if (sensor?.place.kind !== 'ultrasonic') return []
  return castCone(scene.ground, robot, sensor.place, sensor.rays)
}
