import { motorAt, type MotorPort, type SensorKind, type SensorPort } from '@botgarten/simulation'
import type { Draft } from '../draft.ts'

/** How devices are called that are there once. */
const sensorNames: { readonly [kind in SensorKind]?: string } = {
  touch: 'touch_sensor',
  colour: 'color_sensor',
  ultrasonic: 'distance_sensor',
  gyro: 'gyro_sensor',
  infrared: 'infrared_sensor',
  sound: 'sound_sensor',
}

/** `left_motor`, `right_motor`, `motor_a`. */
export function motorName({ input }: Draft, port: MotorPort): string {
  const { left, right } = input.config.drive
  return port === left ? 'left_motor' : port === right ? 'right_motor' : `motor_${port.toLowerCase()}`
}

/** `color_sensor`; where there are two, one on each side, `left_eye` and `right_eye`; else by ports. */
export function sensorName({ input }: Draft, kind: SensorKind, port: SensorPort, shown = port as string) {
  const name = sensorNames[kind] ?? 'sensor'
  const { sensors } = input.config
  const alike = (['1', '2', '3', '4'] as const).filter((one) => sensors[one]?.kind === kind)
  if (alike.length < 2) return name
  const sides = alike.map((one) => Math.sign(sensors[one]!.y))
  if (kind !== 'ultrasonic' || alike.length !== 2 || sides[0] === sides[1]) return `${name}_${shown}`
  return sensors[port]!.y > 0 ? 'left_eye' : 'right_eye'
}

/** What has to sit at a port, in words. */
export function plugOfMotor({ input, say }: Draft, port: MotorPort): string {
  const { left, right } = input.config.drive
  const kind = motorAt(input.config, port)?.kind ?? 'large'
  const side = port === left ? 'left' : port === right ? 'right' : kind
  return say('python.plug', { port, what: say(`python.device.${side}`) })
}

export const plugOfSensor = ({ say }: Draft, port: string, kind: SensorKind | 'force'): string =>
  say('python.plug', { port, what: say(`python.device.${kind}`) })

export const isReversed = ({ input }: Draft, port: MotorPort): boolean =>
  motorAt(input.config, port)?.reversed === true

export const isMedium = ({ input }: Draft, port: MotorPort): boolean =>
  motorAt(input.config, port)?.kind === 'medium'

/** Places in the head of the file: the brick, sensors, motors, what holds both motors, timers. */
export const orders = { brick: 0, sensor: 100, motor: 200, base: 300, timer: 400 } as const
