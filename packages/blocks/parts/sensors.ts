import type { ReadMode, SensorKind, SensorPort } from '@botgarten/simulation'
import type { Block, CheckContext, Context, Definition, Finding, Next } from '../types.ts'
import { sensorPortIn } from './fields.ts'
import { fail, give } from './next.ts'

type Check = readonly Omit<Finding, 'block'>[]
type Fix = NonNullable<Finding['fixes']>[number]

/** Sensors that a program can miss: nobody misses one that sees nothing. */
export type Missed = Exclude<SensorKind, 'irseeker'>

const problems: { readonly [kind in Missed]: string } = {
  ultrasonic: 'problem.noDistanceSensor',
  colour: 'problem.noColourSensor',
  touch: 'problem.noTouchSensor',
  gyro: 'problem.noGyroSensor',
  infrared: 'problem.noInfraredSensor',
  sound: 'problem.noSoundSensor',
  compass: 'problem.noCompassSensor',
  position: 'problem.noPositionSensor',
}
const PORTS = ['1', '2', '3', '4'] as const satisfies readonly SensorPort[]

const portsWith = (kind: SensorKind | undefined, { sensors }: CheckContext): SensorPort[] =>
  PORTS.filter((port) => sensors[port]?.kind === kind)

/** `Anywhere`: the robot has none of this kind · `Empty`: nothing sits at the port · `Here`: something else does. */
const where = (other: SensorPort | undefined, has: SensorKind | undefined) =>
  other === undefined ? 'Anywhere' : has === undefined ? 'Empty' : 'Here'

const elsewhere = (field: string, value: string, port: SensorPort): Fix => ({
  field,
  value,
  words: 'problem.fix.port',
  facts: { port },
})

/** Plugs the sensor in: where the block looks for it, else at the first free port. None where all are taken. */
function pluggingIn(field: string, prefix: string, kind: SensorKind, port: SensorPort | undefined): Fix[] {
  if (port === undefined) return []
  return [{ field, value: prefix + port, words: 'problem.fix.plug', facts: { port }, plug: { port, kind } }]
}

/**
 * A sensor at an empty or wrong port, with a fix a port that is right and one that plugs such a sensor in. `field`:
 * holds the port; `prefix`: of its value. Facts: `port`, `other` (the first right port).
 */
export const sensorAtPort =
  (kind: Missed, field: string, prefix = ''): NonNullable<Definition['check']> =>
  (block: Block, context: CheckContext): Check => {
    const port = sensorPortIn(block, field)
    const has = port && context.sensors[port]?.kind
    if (port === undefined || has === kind) return []
    const others = portsWith(kind, context)
    const free = has === undefined ? port : others.length > 0 ? undefined : portsWith(undefined, context)[0]
    return [
      {
        problem: problems[kind] + where(others[0], has),
        facts: { port, other: others[0] ?? '' },
        fixes: [
          ...others.map((other) => elsewhere(field, prefix + other, other)),
          ...pluggingIn(field, prefix, kind, free),
        ],
        stops: true,
      },
    ]
  }

/** What the sensor at the block's port says. */
export function readAt(block: Block, { robot }: Context, mode: ReadMode): Next {
  const port = sensorPortIn(block, 'SENSORPORT')
  const reading = port === undefined ? null : robot.read(port, mode)
  return reading === null ? fail('nothingToRead') : give(reading)
}

/** Is what the sensor at the block's port says below a limit, or above it? */
export function holdsAt(
  block: Block,
  { robot }: Context,
  mode: ReadMode,
  holds: (reading: number) => boolean,
): Next {
  const port = sensorPortIn(block, 'SENSORPORT')
  const reading = port === undefined ? null : robot.read(port, mode)
  return reading === null ? fail('nothingToRead') : give(holds(Number(reading)))
}
