import { cos, sin } from '@botgarten/numbers'
import { radiansOf } from '../angles.ts'
import { keepLast, onItsWay } from '../body/late.ts'
import { colourOf } from '../floor/colours.ts'
import { spotOf } from '../floor/spot.ts'
import type { Scene } from '../scene.ts'
import type { Colour, Floor, Ray, ReadMode, SensorKind, SensorPlace, SensorPort } from '../types.ts'
import { castCone, CONE } from './cone.ts'
import { PORTS } from './noise.ts'
import { INFRARED, sense, type Sensor, type Sight } from './sense.ts'

/** Readings are worked out when somebody asks, and kept until the world changes. */
export interface Readings extends Sight {
  /** By robot and port: robot · 4 + port − 1. */
  readonly sensors: readonly (Sensor | null)[]
  moment: number
}

/** Numbers a sensor gives. */
const WIDTH = 3

/** Which sensor knows this, and where it stands in its values. */
const MODES: { readonly [mode in ReadMode]: readonly [kind: SensorKind, index: number] } = {
  distance: ['ultrasonic', 0],
  light: ['colour', 0],
  colour: ['colour', 0],
  red: ['colour', 0],
  green: ['colour', 1],
  blue: ['colour', 2],
  touch: ['touch', 0],
  angle: ['gyro', 0],
  rate: ['gyro', 1],
  infrared: ['infrared', 0],
  sound: ['sound', 0],
  compass: ['compass', 0],
  x: ['position', 0],
  y: ['position', 1],
  heading: ['position', 2],
}

/** What each sensor can be asked for. */
export const MODES_OF: { readonly [kind in SensorKind]: readonly ReadMode[] } = {
  ultrasonic: ['distance'],
  colour: ['colour', 'light', 'red', 'green', 'blue'],
  touch: ['touch'],
  gyro: ['angle', 'rate'],
  infrared: ['infrared'],
  sound: ['sound'],
  compass: ['compass'],
  position: ['x', 'y', 'heading'],
  irseeker: [],
}

export function createReadings(scene: Scene, floor: Floor): Readings {
  const sensors = scene.world.robots.flatMap(({ config }) =>
    PORTS.map((port) => (config.sensors[port] ? sensorAt(config.sensors[port]) : null)),
  )
  return { scene, floor, spot: spotOf(floor), sensors, moment: 0 }
}

function sensorAt(place: SensorPlace): Sensor {
  const angles = CONE.map((offset) => radiansOf(place.angle) + offset)
  const rays = Float64Array.from(angles.flatMap((angle) => [cos(angle), sin(angle)]))
  return { place, rays, values: new Float64Array(WIDTH), readAt: -1 }
}

/** See `Simulation.read`. */
export function read(
  readings: Readings,
  robot: number,
  port: SensorPort,
  mode: ReadMode,
): number | Colour | null {
  const index = port.charCodeAt(0) - 49
  const sensor = readings.sensors[robot * PORTS.length + index]
  const [kind, at] = MODES[mode]
  if (sensor?.place.kind !== kind) return null
  const late = readings.scene.state.robots[robot]!.late?.readings
  if (late !== undefined && late.length > 0) return inMode(mode, late, index * WIDTH, at)
  renew(readings, robot, index, sensor)
  return inMode(mode, sensor.values, 0, at)
}

type Numbers = { readonly [index: number]: number }

/** What three numbers from `from` on mean in this mode. */
function inMode(mode: ReadMode, numbers: Numbers, from: number, at: number): number | Colour | null {
  if (mode === 'light') return ((numbers[from]! + numbers[from + 1]! + numbers[from + 2]!) / 3 / 255) * 100
  if (mode === 'colour') return colourOf(numbers[from]!, numbers[from + 1]!, numbers[from + 2]!) ?? ''
  return numbers[from + at]!
}

function renew(readings: Readings, robot: number, port: number, sensor: Sensor): void {
  if (sensor.readAt === readings.moment) return
  sense(readings, robot, port, sensor)
  sensor.readAt = readings.moment
}

/**
 * Before a tick, sends off what the sensors of robots with delay read now: it reaches the program `delay` ticks later.
 * Until the first has come, the first counts.
 */
export function sendReadings(readings: Readings): void {
  readings.scene.world.robots.forEach(({ config: { delay = 0 } }, robot) => {
    if (delay > 0) send(readings, robot, delay)
  })
}

function send(readings: Readings, robot: number, delay: number): void {
  const { readings: sent } = onItsWay(readings.scene.state.robots[robot]!)
  for (let port = 0; port < PORTS.length; port++) {
    const sensor = readings.sensors[robot * PORTS.length + port]
    if (sensor) renew(readings, robot, port, sensor)
    for (let index = 0; index < WIDTH; index++) sent.push(sensor?.values[index] ?? 0)
  }
  keepLast(sent, delay * PORTS.length * WIDTH)
}

/** What a hand moves is seen at once, delay or not. */
export function forgetReadings({ state }: Scene): void {
  for (const { late } of state.robots) if (late) late.readings = []
}

/** See `Simulation.rays`. */
export function raysOf(readings: Readings, robot: number, port: SensorPort): readonly Ray[] {
  const sensor = readings.sensors[robot * PORTS.length + port.charCodeAt(0) - 49]
  const kind = sensor?.place.kind
  if (!sensor || (kind !== 'ultrasonic' && kind !== 'infrared')) return []
  const farthest = kind === 'infrared' ? INFRARED : undefined
  return castCone(readings.scene.ground, robot, sensor.place, sensor.rays, farthest)
}
