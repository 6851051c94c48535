import type { Block } from '@botgarten/blocks'
import { cardConfig, defaultConfig, placeFor } from '@botgarten/simulation'
import type { MotorPort, RobotConfig, SensorKind, SensorPlace, SensorPort } from '@botgarten/simulation'
import * as v from 'valibot'
import type { Program } from '../types.ts'

const brickType = 'robBrick_EV3-Brick'
const typeOf = {
  ultrasonic: 'robBrick_ultrasonic',
  colour: 'robBrick_colour',
  touch: 'robBrick_touch',
  gyro: 'robBrick_gyro',
  infrared: 'robBrick_infrared',
  sound: 'robBrick_sound',
  compass: 'robBrick_compass',
} as const satisfies { readonly [kind in Exclude<SensorKind, 'position'>]: string }
const kindOf = new Map<string, SensorKind>([
  ...Object.entries(typeOf).map(([kind, type]) => [type, kind as SensorKind] as const),
  ['robBrick_htcolour', 'colour'],
])
const sensorPorts: readonly SensorPort[] = ['1', '2', '3', '4']
const motorPorts: readonly MotorPort[] = ['A', 'B', 'C', 'D']

type Config = Program['config']
const brickIn = ({ stacks }: Config) =>
  stacks.flatMap(({ blocks }) => blocks).find(({ type }) => type === brickType)

/** The robot that a file's configuration describes; the one out of the box where it has none. Never throws. */
export function robotIn(config: Config): RobotConfig {
  const brick = brickIn(config)
  if (!brick) return defaultConfig
  return {
    wheelDiameter: lengthIn(brick, 'WHEEL_DIAMETER') ?? defaultConfig.wheelDiameter,
    trackWidth: lengthIn(brick, 'TRACK_WIDTH') ?? defaultConfig.trackWidth,
    sensors: sensorsIn(brick),
    drive: {
      left: motorOf(brick, 'LEFT') ?? defaultConfig.drive.left,
      right: motorOf(brick, 'RIGHT') ?? defaultConfig.drive.right,
    },
  }
}

function lengthIn({ fields }: Block, name: string): number | undefined {
  const length = Number(fields?.[name])
  return length > 0 && length <= 100 ? length : undefined
}

const motorOf = ({ values }: Block, side: string) =>
  motorPorts.find((port) => values?.[`M${port}`]?.fields?.['MOTOR_DRIVE'] === side)

function sensorsIn(brick: Block): RobotConfig['sensors'] {
  const found = sensorPorts.flatMap((port) => {
    const block = brick.values?.[`S${port}`]
    const kind = block && block.disabled !== true ? kindOf.get(block.type) : undefined
    return block && kind ? [{ port, kind, place: placeIn(block, kind) }] : []
  })
  const eyes = found.filter(({ kind, place }) => kind === 'ultrasonic' && !place).map(({ port }) => port)
  let sensors: RobotConfig['sensors'] = {}
  for (const { port, kind, place } of found) {
    const pair = eyes.length === 2 && eyes.includes(port) ? twoEyes[eyes.indexOf(port)] : undefined
    sensors = { ...sensors, [port]: place ?? pair ?? placeFor(kind, { ...defaultConfig, sensors }) }
  }
  return sensors
}

/** Two eyes look to the left and to the right, as on the cards. */
const twoEyes = [cardConfig.sensors[2], cardConfig.sensors[3]] as const

const number = (most: number) => v.pipe(v.number(), v.minValue(-most), v.maxValue(most))
const placeSchema = v.object({ x: number(50), y: number(50), angle: number(360) })

/** Where a sensor sits is ours alone: it travels as the block's data. */
function placeIn({ data }: Block, kind: SensorKind): SensorPlace | undefined {
  if (data === undefined) return undefined
  try {
    const { success, output } = v.safeParse(placeSchema, JSON.parse(data))
    return success ? { kind, ...output } : undefined
  } catch {
    return undefined
  }
}

/**
 * The program with a configuration that describes this robot; unchanged where it does already. Noise, delay and unequal
 * motors stay at home, and so does a sensor that Open Roberta's brick has no block for.
 */
export function withRobot(program: Program, robot: RobotConfig): Program {
  const brick = brickIn(program.config)
  if (brick && isSame(robotIn(program.config), robot)) return program
  if (!brick)
    return { ...program, config: { stacks: [{ x: 213, y: 213, blocks: [brickFor(fresh, robot)] }] } }
  const stacks = program.config.stacks.map(({ blocks, ...place }) => ({
    ...place,
    blocks: blocks.map((block) => (block === brick ? brickFor(brick, robot) : block)),
  }))
  return { ...program, config: { stacks } }
}

const fresh: Block = { id: 'brick', type: brickType, flags: { deletable: 'false' } }

const isSame = (a: RobotConfig, b: RobotConfig) =>
  a.wheelDiameter === b.wheelDiameter &&
  a.trackWidth === b.trackWidth &&
  a.drive.left === b.drive.left &&
  a.drive.right === b.drive.right &&
  sensorPorts.every((port) => isSamePlace(a.sensors[port], b.sensors[port]))

const isSamePlace = (a: SensorPlace | undefined, b: SensorPlace | undefined) =>
  a?.kind === b?.kind && a?.x === b?.x && a?.y === b?.y && a?.angle === b?.angle

function brickFor(brick: Block, robot: RobotConfig): Block {
  const before = sensorsIn(brick)
  const values: Record<string, Block> = { ...brick.values }
  for (const port of sensorPorts) {
    if (isSamePlace(before[port], robot.sensors[port])) continue
    const { [`S${port}`]: old } = values
    delete values[`S${port}`]
    const sensor = sensorFor(port, robot.sensors[port], old)
    if (sensor) values[`S${port}`] = sensor
  }
  for (const port of motorPorts) {
    const motor = motorFor(port, robot.drive, values[`M${port}`])
    if (motor) values[`M${port}`] = motor
  }
  const fields = {
    WHEEL_DIAMETER: String(robot.wheelDiameter),
    TRACK_WIDTH: String(robot.trackWidth),
  }
  return { ...brick, fields: { ...brick.fields, ...fields }, values: inOrder(values) }
}

/** S1 to S4, then MA to MD, as Open Roberta has them. */
const inOrder = (values: { readonly [name: string]: Block }) =>
  Object.fromEntries(
    Object.entries(values).sort(
      ([a], [b]) => Number(b[0] === 'S') - Number(a[0] === 'S') || (a < b ? -1 : 1),
    ),
  )

function sensorFor(port: SensorPort, place: SensorPlace | undefined, old: Block | undefined): Block | null {
  if (!place || place.kind === 'position') return null
  const { kind, ...spot } = place
  const same = old && kindOf.get(old.type) === kind
  return {
    ...(same ? old : { id: `sensor${port}`, type: typeOf[place.kind] }),
    data: JSON.stringify(spot),
  }
}

/** Only motors that drive or drove a wheel change. */
function motorFor(port: MotorPort, drive: RobotConfig['drive'], old: Block | undefined): Block | undefined {
  const side = port === drive.left ? 'LEFT' : port === drive.right ? 'RIGHT' : 'NONE'
  const before = old?.fields?.['MOTOR_DRIVE'] ?? 'NONE'
  if (side === before) return old
  const block = old ?? { id: `motor${port}`, type: 'robBrick_motor_big' }
  const preset = { MOTOR_REGULATION: 'TRUE', MOTOR_REVERSE: 'OFF' }
  return { ...block, fields: { ...preset, ...old?.fields, MOTOR_DRIVE: side } }
}
