import type { SensorKind, SensorPort } from '@botgarten/simulation'
import type { Block, CheckContext, Definition, Finding } from '../types.ts'
import { sensorPortIn } from './fields.ts'

type Check = readonly Omit<Finding, 'block'>[]

const problems = {
  ultrasonic: 'problem.noDistanceSensor',
  colour: 'problem.noColourSensor',
} as const

function portsWith(kind: SensorKind, context: CheckContext): SensorPort[] {
  const ports = Object.keys(context.sensors) as SensorPort[]
  return ports.filter((port) => context.sensors[port]?.kind === kind).sort()
}

/** `Anywhere`: the robot has none of this kind · `Empty`: nothing sits at the port · `Here`: something else does. */
const where = (other: SensorPort | undefined, has: SensorKind | undefined) =>
  other === undefined ? 'Anywhere' : has === undefined ? 'Empty' : 'Here'

const fix = (field: string, value: string, port: SensorPort) => ({
  field,
  value,
  words: 'problem.fix.port',
  facts: { port },
})

/**
 * A sensor at an empty or wrong port, with a fix a port that is right. `field`: holds the port; `prefix`: of its value.
 * Facts: `port`, `other` (the first right port).
 */
export const sensorAtPort =
  (kind: SensorKind, field: string, prefix = ''): NonNullable<Definition['check']> =>
  (block: Block, context: CheckContext): Check => {
    const port = sensorPortIn(block, field)
    const has = port && context.sensors[port]?.kind
    if (port === undefined || has === kind) return []
    const others = portsWith(kind, context)
    return [
      {
        problem: problems[kind] + where(others[0], has),
        facts: { port, other: others[0] ?? '' },
        fixes: others.map((other) => fix(field, prefix + other, other)),
        stops: true,
      },
    ]
  }
