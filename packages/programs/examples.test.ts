import { describe, expect, it } from 'vitest'
import { blockFrom, definitions, toolbox, type Definition, type Template } from '@botgarten/blocks'
import { check, evaluate, indexProgram, networks, runThread, startThread, type Program } from './index.ts'
import { nextTick, recordingRobot } from './testing/recording-robot.ts'

const sockets = {
  sensors: { 1: { kind: 'colour' }, 2: { kind: 'ultrasonic' }, 3: { kind: 'ultrasonic' } },
} as const

function programOf(templates: readonly Template[]): Program {
  let count = 0
  const blocks = templates.map((template) => blockFrom(template, () => `block${count++}`))
  return { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
}

/** Runs to the end, at most 600 ticks. */
function run(program: Program) {
  const recording = recordingRobot()
  const index = indexProgram(program)
  const thread = startThread(index)
  while (!thread.ended && recording.tick < 600) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  return { thread, recording }
}

describe.each(Object.entries(definitions))('the example of %s', (type, definition: Definition) => {
  const program = programOf(definition.example)

  it('stands around the block', () => {
    expect(JSON.stringify(program)).toContain(`"type":"${type}"`)
  })

  it('is checked without a finding', () => {
    expect(check(program, sockets)).toEqual([])
  })

  it('runs to its end or for ten seconds and does something', () => {
    const { thread, recording } = run(program)
    expect(thread.problem).toBeNull()
    const forever = JSON.stringify(program).includes('robControls_loopForever')
    expect(thread.ended).toBe(!forever)
    expect(recording.log.length).toBeGreaterThan(0)
  })

  it('gives numbers for its network that are there before it runs', () => {
    for (const { id, inputs } of networks(program)) {
      const index = indexProgram(program)
      const layer = index.blocks.get(id)?.block.values?.INPUT_LAYER?.id ?? ''
      const values = evaluate(index, layer, recordingRobot().context)
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
      const gaps = check(program, sockets).filter(({ problem }) => problem !== 'problem.missingValue')
      expect(gaps).toEqual([])
      if (check(program, sockets).length === 0) expect(run(program).thread.problem).toBeNull()
    },
  )
})
