import { binds, whole, type Expression, type PythonAt, type RobotPython } from '@botgarten/blocks'
import type { MotorPort, RobotKey, SensorKind, SensorPort } from '@botgarten/simulation'
import type { Draft } from '../draft.ts'
import { colourNames } from './colours.ts'
import { isReversed, motorName, orders, plugOfMotor, plugOfSensor, sensorName } from './devices.ts'

const classes: { readonly [kind in SensorKind]?: string } = {
  touch: 'TouchSensor',
  colour: 'ColorSensor',
  ultrasonic: 'UltrasonicSensor',
  gyro: 'GyroSensor',
  infrared: 'InfraredSensor',
}

const keys: { readonly [key in RobotKey]?: string } = {
  enter: 'CENTER',
  up: 'UP',
  down: 'DOWN',
  left: 'LEFT',
  right: 'RIGHT',
}

const blinks: { readonly [mode: string]: string } = {
  FLASH: '[500, 500]',
  DOUBLE_FLASH: '[150, 150, 150, 550]',
}

const parameter = (draft: Draft, name: string) => draft.import('pybricks.parameters', name)
const color = (draft: Draft, name: string) => `${parameter(draft, 'Color')}.${name}`

/** The brick itself. */
export const brick = (draft: Draft): string =>
  draft.device('brick', () => {
    const name = draft.names.of('device brick', 'ev3')
    return { order: orders.brick, name, code: [`${name} = ${draft.import('pybricks.hubs', 'EV3Brick')}()`] }
  })

export const motor = (draft: Draft, port: MotorPort): string =>
  draft.device(`motor ${port}`, () => {
    const name = draft.names.of(`device motor ${port}`, motorName(draft, port))
    const at = `${parameter(draft, 'Port')}.${port}`
    const turned = isReversed(draft, port) ? `, ${parameter(draft, 'Direction')}.COUNTERCLOCKWISE` : ''
    const code = [`${name} = ${draft.import('pybricks.ev3devices', 'Motor')}(${at}${turned})`]
    return { order: orders.motor + port.charCodeAt(0), name, code, plug: plugOfMotor(draft, port) }
  })

const sensor = (draft: Draft, kind: SensorKind, port: SensorPort): string =>
  draft.device(`sensor ${port}`, () => {
    const name = draft.names.of(`device sensor ${port}`, sensorName(draft, kind, port))
    const made = draft.import('pybricks.ev3devices', classes[kind] ?? '')
    const code = [`${name} = ${made}(${parameter(draft, 'Port')}.S${port})`]
    return { order: orders.sensor + Number(port), name, code, plug: plugOfSensor(draft, port, kind) }
  })

/** Both motors together: they keep to a straight way. */
export function base(draft: Draft): string {
  const { left, right } = draft.input.config.drive
  const motors = `${motor(draft, left)}, ${motor(draft, right)}`
  return draft.device('base', () => {
    const name = draft.names.of('device base', 'robot')
    const { wheelDiameter, trackWidth } = draft.input.config
    const sizes = `wheel_diameter=${mm(wheelDiameter)}, axle_track=${mm(trackWidth)}`
    const code = [`${name} = ${draft.import('pybricks.robotics', 'DriveBase')}(${motors}, ${sizes})`]
    return { order: orders.base, name, code }
  })
}

/** Centimetres as millimetres, without the last digits of a double. */
export const mm = (cm: number): string => String(Number((cm * 10).toPrecision(12)))

const timer = (draft: Draft, number: string): string =>
  draft.device(`timer ${number}`, () => {
    const name = draft.names.of(`device timer ${number}`, `timer_${number}`)
    const code = [`${name} = ${draft.import('pybricks.tools', 'StopWatch')}()`]
    return { order: orders.timer + Number(number), name, code }
  })

const reads: { readonly [what: string]: (name: string, at: PythonAt) => Expression } = {
  device: whole,
  distance: (name) => ({ code: `${name}.distance() / 10`, binds: binds.product }),
  colour: (name) => whole(`${name}.color()`),
  light: (name) => whole(`${name}.reflection()`),
  ambient: (name) => whole(`${name}.ambient()`),
  rgb: (name, at) => whole(at.call('rgb', name)),
  rgb255: (name, at) => whole(at.call('rgb', name)),
  red: (name) => whole(`${name}.rgb()[0]`),
  green: (name) => whole(`${name}.rgb()[1]`),
  blue: (name) => whole(`${name}.rgb()[2]`),
  pressed: (name) => whole(`${name}.pressed()`),
  angle: (name) => whole(`${name}.angle()`),
  rate: (name) => whole(`${name}.speed()`),
  nearness: (name) => whole(`${name}.distance()`),
}

const helped =
  (at: PythonAt, name: string) =>
  (...args: readonly string[]): string =>
    at.call(name, ...args)

/** Pybricks 4 on an EV3. */
export const pybricksRobot =
  (draft: Draft) =>
  (at: PythonAt): RobotPython => ({
    drive: helped(at, 'drive'),
    forward: helped(at, 'forward'),
    spin: helped(at, 'spin'),
    straight: helped(at, 'straight'),
    turn: helped(at, 'turn'),
    curve: helped(at, 'curve'),
    stop: helped(at, 'stop'),
    motor: (port, percent) => `${motor(draft, port)}.run(${at.call('speed', percent)})`,
    motorFor: (port, percent, degrees) =>
      `${motor(draft, port)}.run_angle(${at.call('speed', percent)}, ${degrees})`,
    motorStop: (port, rolls) => `${motor(draft, port)}.${rolls ? 'stop' : 'brake'}()`,
    power: (port) => ({ code: `${motor(draft, port)}.speed() / 7.2`, binds: binds.product }),
    encoder: (port) => whole(`${motor(draft, port)}.angle()`),
    way: (degrees) => wayOf(draft, at, degrees),
    resetEncoder: (port) => `${motor(draft, port)}.reset_angle(0)`,
    read: (kind, port, what) =>
      classes[kind] ? (reads[what]?.(sensor(draft, kind, port), at) ?? null) : null,
    resetGyro: (port) => `${sensor(draft, 'gyro', port)}.reset_angle(0)`,
    timer: (number) => whole(`${timer(draft, number)}.time()`),
    resetTimer: (number) => `${timer(draft, number)}.reset()`,
    key: (key) => keyOf(draft, key),
    lamp: (colour, mode) => lampOf(draft, colour, mode),
    lampColour: (colour) => color(draft, colour),
    show: helped(at, 'show'),
    clear: () => `${brick(draft)}.screen.clear()`,
    tone: (hertz, ms) => toneOf(draft, at, hertz, ms),
    setVolume: (percent) => `${brick(draft)}.speaker.volume(${percent})`,
    volume: () => whole(`${brick(draft)}.speaker.volume()`),
    // Firmware 4 has no voice on the EV3 (pybricks/support#2489).
    say: () => null,
    colour: (colour) => color(draft, colourNames(colour).pybricks),
    wait: (milliseconds) => `${draft.import('pybricks.tools', 'wait')}(${milliseconds})`,
  })

/** cm of a wheel. */
export const wayOf = (draft: Draft, at: PythonAt, degrees: string): string =>
  `${degrees} / 360 * ${at.from('math', 'pi')} * ${draft.input.config.wheelDiameter}`

function keyOf(draft: Draft, key: RobotKey | 'any'): Expression | null {
  const pressed = `${brick(draft)}.buttons.pressed()`
  if (key === 'any') return { code: `len(${pressed}) > 0`, binds: binds.compare, not: `not ${pressed}` }
  const name = keys[key]
  if (!name) return null
  const button = `${parameter(draft, 'Button')}.${name}`
  return { code: `${button} in ${pressed}`, binds: binds.compare, not: `${button} not in ${pressed}` }
}

function lampOf(draft: Draft, colour: string | null, mode: string): string {
  const light = `${brick(draft)}.light`
  if (colour === null) return `${light}.off()`
  const named = color(draft, colour)
  return mode in blinks ? `${light}.blink(${named}, ${blinks[mode]})` : `${light}.on(${named})`
}

const isAbove0 = (code: string) => /^\d+(\.\d+)?$/.test(code) && Number(code) > 0

function toneOf(draft: Draft, at: PythonAt, hertz: string, ms: string): string {
  if (!isAbove0(hertz) || !isAbove0(ms)) return at.call('tone', hertz, ms)
  return `${brick(draft)}.speaker.beep(${hertz}, ${ms})`
}
