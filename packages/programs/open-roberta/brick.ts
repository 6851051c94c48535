import type { Block } from '@botgarten/blocks'
import { partOf, parts } from '@botgarten/blocks/configuration'
import { cardConfig, defaultConfig, isSameMotors, motorPorts, placeFor } from '@botgarten/simulation'
import type { RobotConfig, SensorKind, SensorPlace, SensorPort } from '@botgarten/simulation'
import * as v from 'valibot'
import type { Program } from '../types.ts'
import { motorFor, motorsIn, sidesIn } from './motors.ts'

const brickType = 'robBrick_EV3-Brick'
const sensorPorts: readonly SensorPort[] = ['1', '2', '3', '4']

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
    drive: sidesIn(brick),
    ...motorsIn(brick),
  }
}

function lengthIn({ fields }: Block, name: string): number | undefined {
  const length = Number(fields?.[name])
  return length > 0 && length <= 100 ? length : undefined
}

function sensorsIn(brick: Block): RobotConfig['sensors'] {
  const found = sensorPorts.flatMap((port) => {
    const block = brick.values?.[`S${port}`]
    const is = block && block.disabled !== true ? sensorOf(block) : undefined
    return block && is ? [{ port, ...is, place: placeIn(block, is.kind) }] : []
  })
  const eyes = found.filter(({ kind, place }) => kind === 'ultrasonic' && !place).map(({ port }) => port)
  let sensors: RobotConfig['sensors'] = {}
  for (const { port, kind, place, ...maker } of found) {
    const pair = eyes.length === 2 && eyes.includes(port) ? twoEyes[eyes.indexOf(port)] : undefined
    const spot = place ?? pair ?? placeFor(kind, { ...defaultConfig, sensors })
    sensors = { ...sensors, [port]: { ...spot, ...maker } }
  }
  return sensors
}

/** Which sensor a block is; undefined where it is none, or nobody knows it. */
function sensorOf({ type }: Block): Pick<SensorPlace, 'kind' | 'maker'> | undefined {
  const is = partOf(type)?.is
  return is && 'sensor' in is ? { kind: is.sensor, ...(is.maker && { maker: is.maker }) } : undefined
}

const typeOf = ({ kind, maker }: SensorPlace) =>
  parts.find(({ is }) => 'sensor' in is && is.sensor === kind && is.maker === maker)?.type

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
 * motors stay at home, and so does a sensor that Open Roberta's brick has no block for. What a file says in blocks that
 * are unknown here stays in it, whatever is changed beside it.
 */
export function withRobot(program: Program, robot: RobotConfig): Program {
  const { config, raw } = program
  const brick = brickIn(config)
  const comesFromFile = raw !== undefined || config.stacks.length > 0
  if ((brick || comesFromFile) && isSame(robotIn(config), robot)) return program
  if (!brick) {
    const added = { x: 213, y: 213, blocks: [brickFor(fresh, robot)] }
    return { ...program, config: { stacks: [...config.stacks, added] } }
  }
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
  isSameMotors(a, b) &&
  sensorPorts.every((port) => isSamePlace(a.sensors[port], b.sensors[port]))

const isSamePlace = (a: SensorPlace | undefined, b: SensorPlace | undefined) =>
  a?.kind === b?.kind && a?.maker === b?.maker && a?.x === b?.x && a?.y === b?.y && a?.angle === b?.angle

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
    const { [`M${port}`]: old } = values
    delete values[`M${port}`]
    const motor = motorFor(port, robot, old)
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
  const type = place && typeOf(place)
  if (!type) return null
  const { kind: _kind, maker: _maker, ...spot } = place
  const same = old?.type === type
  return { ...(same ? old : { id: `sensor${port}`, type }), data: JSON.stringify(spot) }
}
