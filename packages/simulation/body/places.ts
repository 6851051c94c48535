import { FRONT, REAR } from '../geometry/parts.ts'
import type { Cm, Degrees, RobotConfig, SensorKind, SensorPlace, SensorPort } from '../types.ts'

type Spot = readonly [x: Cm, y: Cm, angle: Degrees]

/** Where sensors that look ahead go, one after the other: in front, to both sides, behind. */
const eyes: readonly Spot[] = [
  [FRONT, 0, 0],
  [FRONT, 4, 20],
  [FRONT, -4, -20],
  [-REAR, 0, 180],
]
const inside: readonly Spot[] = [
  [0, 0, 0],
  [-3, 3, 0],
  [-3, -3, 0],
  [-4.5, 0, 0],
]
const spots: { readonly [kind in SensorKind]: readonly Spot[] } = {
  ultrasonic: eyes,
  infrared: eyes,
  colour: [
    [5, 0, 0],
    [5, 2.5, 0],
    [5, -2.5, 0],
    [5, 5, 0],
  ],
  touch: [
    [FRONT, 0, 0],
    [-REAR, 0, 180],
  ],
  gyro: inside,
  sound: inside,
  compass: inside,
  position: inside,
  irseeker: eyes,
}

/** Sensors nearer than this lie on each other. A bumper is a bar: other sensors may sit on it. */
const APART: Cm = 2

/** Where a new sensor of this kind goes: the first of its places that is free, the first of all where none is. */
export function placeFor(kind: SensorKind, { sensors }: RobotConfig): SensorPlace {
  const others = Object.values(sensors).filter((other) => (other.kind === 'touch') === (kind === 'touch'))
  const isFree = ([x, y]: Spot) =>
    others.every((other) => Math.abs(other.x - x) >= APART || Math.abs(other.y - y) >= APART)
  const [x, y, angle] = spots[kind].find(isFree) ?? spots[kind][0]!
  return { kind, x, y, angle }
}

/** The configuration with a sensor more, or another one at this port. */
export const withSensor = (config: RobotConfig, port: SensorPort, place: SensorPlace): RobotConfig => ({
  ...config,
  sensors: { ...config.sensors, [port]: place },
})

/** The configuration without what sits at this port. */
export function withoutSensor(config: RobotConfig, port: SensorPort): RobotConfig {
  const { [port]: _gone, ...sensors } = config.sensors
  return { ...config, sensors }
}
