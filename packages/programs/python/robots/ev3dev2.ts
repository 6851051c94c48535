import { binds, whole, type Expression, type PythonAt, type RobotPython } from '@botgarten/blocks'
import type { MotorPort, RobotKey, SensorKind, SensorPort } from '@botgarten/simulation'
import type { Draft } from '../draft.ts'
import { colourNames } from './colours.ts'
import { isMedium, isReversed, motorName, orders, plugOfMotor, plugOfSensor, sensorName } from './devices.ts'
import { wayOf } from './pybricks.ts'

const classes: { readonly [kind in SensorKind]?: string } = {
  touch: 'TouchSensor',
  colour: 'ColorSensor',
  ultrasonic: 'UltrasonicSensor',
  gyro: 'GyroSensor',
  infrared: 'InfraredSensor',
  sound: 'SoundSensor',
}

const keys: { readonly [key in RobotKey | 'any']?: string } = {
  enter: 'enter',
  up: 'up',
  down: 'down',
  left: 'left',
  right: 'right',
  escape: 'backspace',
  any: 'any()',
}

const single = (module: string, made: string, wanted: string) => (draft: Draft) =>
  draft.device(wanted, () => {
    const name = draft.names.of(`device ${wanted}`, wanted)
    return { order: orders.brick, name, code: [`${name} = ${draft.import(module, made)}()`] }
  })

export const screen = single('ev3dev2.display', 'Display', 'screen')
export const sound = single('ev3dev2.sound', 'Sound', 'sound')
export const leds = single('ev3dev2.led', 'Leds', 'leds')
const buttons = single('ev3dev2.button', 'Button', 'buttons')

const output = (draft: Draft, port: MotorPort) => draft.import('ev3dev2.motor', `OUTPUT_${port}`)

const motor = (draft: Draft, port: MotorPort): string =>
  draft.device(`motor ${port}`, () => {
    const name = draft.names.of(`device motor ${port}`, motorName(draft, port))
    const made = draft.import('ev3dev2.motor', isMedium(draft, port) ? 'MediumMotor' : 'LargeMotor')
    const code = [`${name} = ${made}(${output(draft, port)})`]
    if (isReversed(draft, port)) code.push(`${name}.polarity = ${made}.POLARITY_INVERSED`)
    return { order: orders.motor + port.charCodeAt(0), name, code, plug: plugOfMotor(draft, port) }
  })

/** Both motors together. */
export function tank(draft: Draft): string {
  const { left, right } = draft.input.config.drive
  for (const port of [left, right]) if (isReversed(draft, port)) motor(draft, port)
  return draft.device('base', () => {
    const name = draft.names.of('device base', 'wheels')
    const made = draft.import('ev3dev2.motor', 'MoveTank')
    const code = [`${name} = ${made}(${output(draft, left)}, ${output(draft, right)})`]
    return {
      order: orders.base,
      name,
      code,
      plug: `${plugOfMotor(draft, left)}\n${plugOfMotor(draft, right)}`,
    }
  })
}

const sensor = (draft: Draft, kind: SensorKind, port: SensorPort): string =>
  draft.device(`sensor ${port}`, () => {
    const name = draft.names.of(`device sensor ${port}`, sensorName(draft, kind, port))
    const made = draft.import('ev3dev2.sensor.lego', classes[kind] ?? '')
    const code = [`${name} = ${made}(${draft.import('ev3dev2.sensor', `INPUT_${port}`)})`]
    return { order: orders.sensor + Number(port), name, code, plug: plugOfSensor(draft, port, kind) }
  })

const timer = (draft: Draft, number: string): string =>
  draft.device(`timer ${number}`, () => {
    const name = draft.names.of(`device timer ${number}`, `timer_${number}`)
    const code = [`${name} = ${draft.import('ev3dev2.stopwatch', 'StopWatch')}()`, `${name}.start()`]
    return { order: orders.timer + Number(number), name, code }
  })

const property = (of: string) => (name: string) => whole(`${name}.${of}`)
const channel = (k: number) => (name: string) => ({ code: `${name}.rgb[${k}] / 2.55`, binds: binds.product })

const reads: { readonly [what: string]: (name: string, at: PythonAt) => Expression } = {
  device: whole,
  distance: property('distance_centimeters'),
  colour: property('color'),
  light: property('reflected_light_intensity'),
  ambient: property('ambient_light_intensity'),
  rgb: (name) => whole(`list(${name}.rgb)`),
  rgb255: (name) => whole(`list(${name}.rgb)`),
  red: channel(0),
  green: channel(1),
  blue: channel(2),
  pressed: property('is_pressed'),
  angle: property('angle'),
  rate: property('rate'),
  nearness: property('proximity'),
  sound: property('sound_pressure'),
}

const helped =
  (at: PythonAt, name: string) =>
  (...args: readonly string[]): string =>
    at.call(name, ...args)

/** ev3dev with python-ev3dev2. */
export const ev3dev2Robot =
  (draft: Draft) =>
  (at: PythonAt): RobotPython => ({
    drive: helped(at, 'drive'),
    forward: helped(at, 'forward'),
    spin: helped(at, 'spin'),
    straight: helped(at, 'straight'),
    turn: helped(at, 'turn'),
    curve: helped(at, 'curve'),
    stop: () => `${tank(draft)}.off()`,
    motor: (port, percent) => `${motor(draft, port)}.on(${at.call('speed', percent)})`,
    motorFor: (port, percent, degrees) =>
      `${motor(draft, port)}.on_for_degrees(${at.call('speed', percent)}, ${degrees})`,
    motorStop: (port, rolls) => `${motor(draft, port)}.off(${rolls ? 'brake=False' : ''})`,
    power: (port) => ({ code: `${motor(draft, port)}.speed / 7.2`, binds: binds.product }),
    encoder: (port) => whole(`${motor(draft, port)}.position`),
    way: (degrees) => wayOf(draft, at, degrees),
    resetEncoder: (port) => `${motor(draft, port)}.position = 0`,
    read: (kind, port, what) =>
      classes[kind] ? (reads[what]?.(sensor(draft, kind, port), at) ?? null) : null,
    resetGyro: (port) => `${sensor(draft, 'gyro', port)}.reset()`,
    timer: (number) => whole(`${timer(draft, number)}.value_ms`),
    resetTimer: (number) => `${timer(draft, number)}.restart()`,
    key: (key) => (keys[key] ? whole(`${buttons(draft)}.${keys[key]}`) : null),
    lamp: (colour, mode) => lampOf(draft, at, colour, mode),
    lampColour: (colour) => `"${amber(colour)}"`,
    show: helped(at, 'show'),
    clear: helped(at, 'clear'),
    tone: (hertz, ms) => toneOf(draft, at, hertz, ms),
    setVolume: (percent) => `${sound(draft)}.set_volume(${wholePercent(percent)})`,
    volume: () => whole(`${sound(draft)}.get_volume()`),
    say: (text, speed, pitch) => sayOf(draft, at, text, speed, pitch),
    colour: (colour) =>
      `${draft.import('ev3dev2.sensor.lego', 'ColorSensor')}.${colourNames(colour).ev3dev2}`,
    wait: (ms) => `${draft.import('time', 'sleep')}(${seconds(ms)})`,
  })

const wholePercent = (code: string) => (/^\d+$/.test(code) ? code : `int(${code})`)

const seconds = (ms: string): string => {
  if (/^\d+(\.\d+)?$/.test(ms)) return String(Number((Number(ms) / 1000).toPrecision(12)))
  return /^-/.test(ms) && Number.isFinite(Number(ms)) ? '0' : `max(0, ${ms}) / 1000`
}

const amber = (colour: string) => (colour === 'ORANGE' ? 'AMBER' : colour)

function lampOf(draft: Draft, at: PythonAt, colour: string | null, mode: string): string {
  if (colour === null) return at.call('lamp', 'None')
  if (mode === 'ON') return at.call('lamp', `"${amber(colour)}"`)
  const pace = mode === 'FLASH' ? '0.5' : '0.15'
  return `${leds(draft)}.animate_flash("${amber(colour)}", sleeptime=${pace}, duration=None, block=False)`
}

const isAbove0 = (code: string) => /^\d+(\.\d+)?$/.test(code) && Number(code) > 0

function toneOf(draft: Draft, at: PythonAt, hertz: string, ms: string): string {
  if (!isAbove0(hertz) || !isAbove0(ms)) return at.call('tone', hertz, ms)
  return `${sound(draft)}.play_tone(${hertz}, ${seconds(ms)})`
}

function sayOf(draft: Draft, at: PythonAt, text: string, speed?: string, pitch?: string): string {
  if (speed === undefined || pitch === undefined) return `${sound(draft)}.speak(${text})`
  return at.call('say', text, speed, pitch)
}
