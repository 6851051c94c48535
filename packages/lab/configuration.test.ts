import { addBlocks, blockFrom, type Block, type Template } from '@botgarten/blocks'
import { parts, type Part } from '@botgarten/blocks/configuration'
import { expert } from '@botgarten/blocks/packs/expert'
import { projectFrom, writeOpenRoberta } from '@botgarten/programs/open-roberta'
import { paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { createLab } from './index.ts'
import { worldWith } from './testing/scene.ts'

addBlocks(expert)

const world: World = { ...worldWith(), obstacles: [] }

/** An Open Roberta file: a small program, and a brick with what is plugged into it. */
function fileOf({ plugged, brick = {}, program }: Part['example']): string {
  let count = 0
  const made = (template: Template) => blockFrom(template, () => `b${count++}`)
  const block: Block = {
    ...{ id: 'brick', type: 'robBrick_EV3-Brick' },
    fields: { WHEEL_DIAMETER: '5.6', TRACK_WIDTH: '18', ...brick },
    values: Object.fromEntries(Object.entries(plugged).map(([port, part]) => [port, made(part)])),
  }
  return writeOpenRoberta({
    stacks: [{ x: 0, y: 0, blocks: program.map(made) }],
    config: { stacks: [{ x: 213, y: 213, blocks: [block] }] },
  })
}

/** Opens the file as it is, and runs it for so many ticks: how far ahead it has come, how far it has turned. */
function run(example: Part['example'], ticks = 180) {
  const project = projectFrom(fileOf(example), 'x', world)
  const lab = createLab()
  lab.load(project, paintFloor(project.world), { seed: 1, checks: [] })
  lab.start()
  lab.advance(ticks)
  const { pose, problem, display } = lab.view().robots[0]!
  return { way: pose.y - 100, turn: pose.heading - 90, problem, display }
}

/** The same without the part itself. */
function without({ type, example }: Part): Part['example'] {
  const plugged = Object.entries(example.plugged).filter(([, part]) => part.type !== type)
  return { plugged: Object.fromEntries(plugged), program: example.program }
}

const turnOf = (port: string): readonly Template[] =>
  exampleOf('motor_middle').program.map((block) =>
    block.fields?.['MOTORPORT'] ? { ...block, fields: { ...block.fields, MOTORPORT: port } } : block,
  )

const exampleOf = (type: string) => parts.find((part) => part.type === `robBrick_${type}`)!.example
const sensors = parts.filter(({ is }) => 'sensor' in is)

describe('the example of a part of the configuration', () => {
  it.each(parts.map((part) => [part.type, part] as const))('%s: runs without a problem', (_, { example }) => {
    expect(run(example).problem).toBeNull()
  })

  it.each(
    sensors.filter(({ type }) => type !== 'robBrick_irseeker').map((part) => [part.type, part] as const),
  )('%s: stops without it', (_, part) => {
    expect(run(without(part)).problem).not.toBeNull()
  })

  it('EV3-Brick: a way is as far as its block says on wheels of any size, and larger wheels are there sooner', () => {
    const example = exampleOf('EV3-Brick')
    expect(run(example).way).toBeCloseTo(20, 6)
    // 30 % are 0.6 turns a second.
    expect(run(example, 30).way).toBeCloseTo(0.3 * Math.PI * 8, 6)
    expect(run({ ...example, brick: {} }, 30).way).toBeCloseTo(0.3 * Math.PI * 5.6, 6)
  })

  it('EV3-Brick: one turn of the right wheel turns the robot by its way over the track width', () => {
    const example = { ...exampleOf('motor_middle'), program: turnOf('B') }
    const turned = (TRACK_WIDTH: string) => run({ ...example, brick: { TRACK_WIDTH } }).turn
    expect(turned('18')).toBeCloseTo((5.6 / 18) * 180, 6)
    expect(turned('36')).toBeCloseTo((5.6 / 36) * 180, 6)
  })

  it('motor_big: turned backwards at the left wheel, the robot drives backwards', () => {
    expect(run(exampleOf('motor_big')).way).toBeCloseTo(-20, 6)
  })

  it('motor_big: a right motor that turns backwards changes nothing, as in Open Roberta’s simulation', () => {
    const example = exampleOf('motor_big')
    const { MC, ...plugged } = example.plugged
    const left = { ...MC!, fields: { ...MC!.fields, MOTOR_REVERSE: 'OFF' } }
    expect(run({ ...example, plugged: { ...plugged, MC: left } }).way).toBeCloseTo(20, 6)
  })

  it('motor_big: the wheels go by their motors’ sides, not by their ports', () => {
    const example = exampleOf('motor_middle')
    const { MB, MC } = example.plugged
    const crossed = { ...example, plugged: { MB: MC!, MC: MB! }, program: turnOf('B') }
    expect(run(crossed).turn).toBeCloseTo(-(5.6 / 18) * 180, 6)
  })
})
