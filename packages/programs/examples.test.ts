import { describe, expect, it } from 'vitest'
import {
  addBlocks,
  blockFrom,
  definitions,
  stacksOf,
  type CheckContext,
  type Definition,
  type Template,
} from '@botgarten/blocks'
import { expert, expertToolbox as toolbox } from '@botgarten/blocks/packs/expert'
import { check, evaluate, indexProgram, networks, runThread, startThread, type Program } from './index.ts'
import type { SensorKind } from '@botgarten/simulation'
import { cardSensors, nextTick, recordingRobot } from './testing/recording-robot.ts'

addBlocks(expert)

const kinds: readonly (readonly [type: RegExp, kind: SensorKind])[] = [
  [/Sensors_touch/, 'touch'],
  [/Sensors_gyro/, 'gyro'],
  [/Sensors_infrared/, 'infrared'],
  [/Sensors_sound/, 'sound'],
  [/Sensors_compass/, 'compass'],
  [/Sensors_odometry/, 'position'],
]

/** The cards' robot, with the other sensors of these blocks plugged in where they look for them. */
function socketsFor(templates: readonly Template[]): CheckContext {
  const plugged = templates.flatMap(within).flatMap(({ type, fields }) => {
    const kind = kinds.find(([pattern]) => pattern.test(type))?.[1]
    return kind ? [[fields?.SENSORPORT, { kind }]] : []
  })
  return { sensors: { ...cardSensors, ...(Object.fromEntries(plugged) as CheckContext['sensors']) } }
}

const within = (template: Template): Template[] => [
  template,
  ...Object.values(template.values ?? {}).flatMap(within),
  ...Object.values(template.statements ?? {}).flatMap((rows) => rows.flatMap(within)),
]

function programOf(templates: readonly Template[]): Program {
  let count = 0
  const stacks = stacksOf(templates).map((rows) => ({
    x: 0,
    y: 0,
    blocks: rows.map((template) => blockFrom(template, () => `block${count++}`)),
  }))
  return { stacks, config: { stacks: [] } }
}

/** Runs to the end, at most 600 ticks. */
function run(program: Program, { sensors }: CheckContext) {
  const recording = recordingRobot(2, sensors)
  const index = indexProgram(program)
  const thread = startThread(index)
  thread.letters.push({ from: 'bo2', kind: 'call', text: '' }, { from: 'bo2', kind: 'text', text: 'Hallo' })
  while (!thread.ended && recording.tick < 600) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  return { thread, recording }
}

describe.each(Object.entries(definitions))('the example of %s', (type, definition: Definition) => {
  const program = programOf(definition.example)
  const sockets = socketsFor(definition.example)

  it('stands around the block', () => {
    expect(JSON.stringify(program)).toContain(`"type":"${type}"`)
  })

  it('is checked without a finding', () => {
    expect(check(program, sockets)).toEqual([])
  })

  it('runs to its end or for ten seconds and does something', () => {
    const { thread, recording } = run(program, sockets)
    expect(thread.problem).toBeNull()
    const forever = JSON.stringify(program).includes('robControls_loopForever')
    const isLeft = JSON.stringify(program).includes('BREAK')
    expect(thread.ended).toBe(!forever || isLeft)
    expect(recording.log.length).toBeGreaterThan(0)
  })

  it('gives numbers for its network that are there before it runs', () => {
    for (const { id, inputs } of networks(program)) {
      const index = indexProgram(program)
      const layer = index.blocks.get(id)?.block.values?.INPUT_LAYER?.id ?? ''
      const values = evaluate(index, layer, recordingRobot(2, sockets.sensors).context)
      expect(values).toHaveLength(inputs.length)
    }
  })
})

describe('the toolbox', () => {
  const statements = toolbox
    .flatMap(({ blocks }) => blocks)
    .filter(({ type }) => definitions[type as keyof typeof definitions].look.shape === 'statement')

  it.each(statements.map((template) => [template.type, template] as const))(
    '%s runs as it comes out, where it has no gap',
    (_type, template) => {
      const start = definitions.robControls_start.example[0]!
      const program = programOf([start, template])
      const sockets = socketsFor([template])
      const around = ['problem.missingValue', 'problem.notInLoop', 'problem.notInFunction']
      const gaps = check(program, sockets).filter(({ problem }) => !around.includes(problem))
      expect(gaps).toEqual([])
      if (check(program, sockets).length === 0) expect(run(program, sockets).thread.problem).toBeNull()
    },
  )
})
