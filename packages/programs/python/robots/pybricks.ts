import { binds, whole, type Expression, type PythonAt, type RobotPython } from '@botgarten/blocks'
import type { MotorPort, RobotKey, SensorKind, SensorPort } from '@botgarten/simulation'
import type { Draft } from '../draft.ts'
import { colourNames, sensedColours } from './colours.ts'
import { isReversed, motorName, orders, plugOfMotor, plugOfSensor, sensorName } from './devices.ts'
import { hubOf, readsOf } from './hub.ts'

const blinks: { readonly [mode: string]: string } = {
  FLASH: '[500, 500]',
  DOUBLE_FLASH: '[150, 150, 150, 550]',
}

const parameter = (draft: Draft, name: string) => draft.import('pybricks.parameters', name)
const color = (draft: Draft, name: string) => `${parameter(draft, 'Color')}.${name}`

/** The brick itself. */
export const brick = (draft: Draft): string =>
  draft.device('brick', () => {
    const { made, name: wanted } = hubOf(draft)
    const name = draft.names.of('device brick', wanted)
    return { order: orders.brick, name, code: [`${name} = ${draft.import('pybricks.hubs', made)}()`] }
  })

export const motor = (draft: Draft, port: MotorPort): string =>
  draft.device(`motor ${port}`, () => {
    const name = draft.names.of(`device motor ${port}`, motorName(draft, port))
    const at = `${parameter(draft, 'Port')}.${port}`
    const turned = turnsRound(draft, port) ? `, ${parameter(draft, 'Direction')}.COUNTERCLOCKWISE` : ''
    const code = [`${name} = ${draft.import(hubOf(draft).devices, 'Motor')}(${at}${turned})`]
    return { order: orders.motor + port.charCodeAt(0), name, code, plug: plugOfMotor(draft, port) }
  })

function turnsRound(draft: Draft, port: MotorPort): boolean {
  const mirrored = hubOf(draft).mirrored && port === draft.input.config.drive.left
  return mirrored !== isReversed(draft, port)
}

/** A sensor where it is plugged in. */
function sensor(draft: Draft, kind: SensorKind, port: SensorPort, letter: string): string {
  const { devices, sensors, portSign } = hubOf(draft)
  return draft.device(`sensor ${port}`, () => {
    const name = draft.names.of(`device sensor ${port}`, sensorName(draft, kind, port, letter.toLowerCase()))
    const made = draft.import(devices, sensors[kind] ?? '')
    const code = [`${name} = ${made}(${parameter(draft, 'Port')}.${portSign}${letter})`]
    const what = made === 'ForceSensor' ? 'force' : kind
    return { order: orders.sensor + Number(port), name, code, plug: plugOfSensor(draft, letter, what) }
  })
}

function readingOf(draft: Draft, at: PythonAt, kind: SensorKind, port: SensorPort, what: string) {
  const { dialect, config } = draft.input
  if (dialect === 'spike' && kind === 'gyro') return builtIn(draft, what)
  const read = readsOf[dialect]?.[what]
  if (!hubOf(draft).sensors[kind] || !read) return null
  const letter = hubOf(draft).plug(config, port)
  if (letter === undefined) return at.missing('ports')
  const name = sensor(draft, kind, port, letter)
  if (dialect === 'spike' && (what === 'colour' || (what === 'device' && kind === 'colour')))
    tellApart(draft, name, port)
  return read(name, at)
}

/** The gyroscope in the hub. Pybricks counts its speed to the left above 0. */
function builtIn(draft: Draft, what: string): Expression {
  if (what === 'angle') return whole(`${brick(draft)}.imu.heading()`)
  const axis = `${parameter(draft, 'Axis')}.Z`
  return { code: `-${brick(draft)}.imu.angular_velocity(${axis})`, binds: binds.sign }
}

/** Without being told the sensor of SPIKE Prime knows neither black nor brown. */
function tellApart(draft: Draft, name: string, port: SensorPort): void {
  draft.device(`colours ${port}`, () => {
    const known = sensedColours.map((one) => color(draft, one)).join(', ')
    return {
      order: orders.sensor + Number(port) + 0.5,
      name,
      code: [`${name}.detectable_colors([${known}])`],
    }
  })
}

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

const helped =
  (at: PythonAt, name: string) =>
  (...args: readonly string[]): string =>
    at.call(name, ...args)

/** Pybricks 4 on an EV3, or on a SPIKE Prime hub. */
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
    read: (kind, port, what) => readingOf(draft, at, kind, port, what),
    resetGyro: (port) =>
      draft.input.dialect === 'spike'
        ? `${brick(draft)}.imu.reset_heading(0)`
        : `${sensor(draft, 'gyro', port, port)}.reset_angle(0)`,
    timer: (number) => whole(`${timer(draft, number)}.time()`),
    resetTimer: (number) => `${timer(draft, number)}.reset()`,
    key: (key) => keyOf(draft, key),
    lamp: (colour, mode) => lampOf(draft, colour, mode),
    lampColour: (colour) => color(draft, colour),
    show: (text, column, row) =>
      draft.input.dialect === 'spike' ? at.call('show', text) : at.call('show', text, column, row),
    clear: () => (draft.input.dialect === 'spike' ? at.call('clear') : `${brick(draft)}.screen.clear()`),
    tone: (hertz, ms) => toneOf(draft, at, hertz, ms),
    setVolume: (percent) => `${brick(draft)}.speaker.volume(${percent})`,
    volume: () => whole(`${brick(draft)}.speaker.volume()`),
    // Pybricks has no voice (pybricks/support#2489).
    say: () => null,
    colour: (colour) => color(draft, colourNames(colour).pybricks),
    wait: (milliseconds) => `${draft.import('pybricks.tools', 'wait')}(${milliseconds})`,
  })

/** cm of a wheel. */
export const wayOf = (draft: Draft, at: PythonAt, degrees: string): string =>
  `${degrees} / 360 * ${at.from('math', 'pi')} * ${draft.input.config.wheelDiameter}`

/** The key in the middle ends a program on SPIKE Prime: where it is asked for, another one does. */
const freeMiddleKey = (draft: Draft) =>
  draft.device('stop button', () => ({
    ...{ order: orders.brick + 1, name: '' },
    code: [
      `# ${draft.say('python.stopButton')}`,
      `${brick(draft)}.system.set_stop_button(${parameter(draft, 'Button')}.BLUETOOTH)`,
    ],
  }))

function keyOf(draft: Draft, key: RobotKey | 'any'): Expression | null {
  const pressed = `${brick(draft)}.buttons.pressed()`
  if (key === 'any') return { code: `len(${pressed}) > 0`, binds: binds.compare, not: `not ${pressed}` }
  const name = hubOf(draft).keys[key]
  if (!name) return null
  const button = `${parameter(draft, 'Button')}.${name}`
  if (draft.input.dialect === 'spike' && name === 'CENTER') freeMiddleKey(draft)
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
