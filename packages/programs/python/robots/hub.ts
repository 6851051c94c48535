import { binds, whole, type Expression, type PythonAt } from '@botgarten/blocks'
import { motorAt, motorPorts, type RobotKey, type SensorKind, type SensorPort } from '@botgarten/simulation'
import type { Draft } from '../draft.ts'
import type { Dialect, PythonInput } from '../types.ts'

type Config = PythonInput['config']

/** What differs between the bricks that Pybricks runs on. */
interface Hub {
  /** Its class in `pybricks.hubs`, and how a file calls it. */
  readonly made: string
  readonly name: string
  /** Module of its motors and sensors. */
  readonly devices: string
  readonly sensors: { readonly [kind in SensorKind]?: string }
  readonly keys: { readonly [key in RobotKey]?: string }
  /** Where a sensor of the configuration is plugged in; undefined: there is no place for it. */
  readonly plug: (config: Config, port: SensorPort) => string | undefined
  /** Before the letter of a sensor's port in `Port`. */
  readonly portSign: string
  /** The motors of the wheels look at each other: the left one turns the other way round. */
  readonly mirrored: boolean
}

const ev3: Hub = {
  ...{ made: 'EV3Brick', name: 'ev3', devices: 'pybricks.ev3devices' },
  sensors: {
    touch: 'TouchSensor',
    colour: 'ColorSensor',
    ultrasonic: 'UltrasonicSensor',
    gyro: 'GyroSensor',
    infrared: 'InfraredSensor',
  },
  keys: { enter: 'CENTER', up: 'UP', down: 'DOWN', left: 'LEFT', right: 'RIGHT' },
  plug: (_, port) => port,
  portSign: 'S',
  mirrored: false,
}

/** A gyroscope is built in. */
const prime: Hub = {
  ...{ made: 'PrimeHub', name: 'hub', devices: 'pybricks.pupdevices' },
  sensors: { touch: 'ForceSensor', colour: 'ColorSensor', ultrasonic: 'UltrasonicSensor' },
  keys: { left: 'LEFT', right: 'RIGHT', enter: 'CENTER' },
  plug: (config, port) => primePorts(config)[port],
  portSign: '',
  mirrored: true,
}

/** Motors keep the letters of their ports; sensors take those that are left, in the order of the configuration. */
export function primePorts(config: Config): { readonly [port in SensorPort]?: string } {
  const left = ['A', 'B', 'C', 'D', 'E', 'F'].filter(
    (letter) => !motorPorts.some((port) => port === letter && motorAt(config, port)),
  )
  const plugged = (['1', '2', '3', '4'] as const).filter((port) => {
    const kind = config.sensors[port]?.kind
    return kind !== undefined && prime.sensors[kind] !== undefined
  })
  return Object.fromEntries(plugged.slice(0, left.length).map((port, k) => [port, left[k]!]))
}

const hubs: { readonly [dialect in Dialect]?: Hub } = { pybricks: ev3, spike: prime }
export const hubOf = ({ input }: Draft): Hub => hubs[input.dialect] ?? ev3

type Reads = { readonly [what: string]: (name: string, at: PythonAt) => Expression }

const rgb = (name: string, at: PythonAt) => at.call('rgb', name)
const channel = (k: number) => (name: string, at: PythonAt) => ({
  code: `${rgb(name, at)}[${k}] / 2.55`,
  binds: binds.product,
})

const shared: Reads = {
  device: whole,
  distance: (name) => ({ code: `${name}.distance() / 10`, binds: binds.product }),
  colour: (name) => whole(`${name}.color()`),
  light: (name) => whole(`${name}.reflection()`),
  ambient: (name) => whole(`${name}.ambient()`),
  rgb: (name, at) => whole(rgb(name, at)),
  rgb255: (name, at) => whole(rgb(name, at)),
  pressed: (name) => whole(`${name}.pressed()`),
}

/** What a sensor is asked for. */
export const readsOf: { readonly [dialect in Dialect]?: Reads } = {
  pybricks: {
    ...shared,
    red: (name) => whole(`${name}.rgb()[0]`),
    green: (name) => whole(`${name}.rgb()[1]`),
    blue: (name) => whole(`${name}.rgb()[2]`),
    angle: (name) => whole(`${name}.angle()`),
    rate: (name) => whole(`${name}.speed()`),
    nearness: (name) => whole(`${name}.distance()`),
  },
  spike: { ...shared, red: channel(0), green: channel(1), blue: channel(2) },
}
