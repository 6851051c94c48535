import { readFileSync, readdirSync } from 'node:fs'
import { cardConfig, defaultConfig, type RobotConfig, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { parseProject, writeProject, type Program, type Project } from '../index.ts'
import { xmlTree } from '../testing/xml-tree.ts'
import { robotIn, withRobot } from './brick.ts'
import { fileFrom, projectFrom, readOpenRoberta } from './index.ts'

const folder = new URL('../testing/open-roberta/programs/', import.meta.url)
const files = readdirSync(folder)
const textOf = (file: string) => readFileSync(new URL(file, folder), 'utf8')
const read = (path: string): unknown =>
  JSON.parse(readFileSync(new URL(`../../../content/${path}`, import.meta.url), 'utf8'))
const garden = read('worlds/garden/world.json') as World
const card = 'cards/network/05-friendship'

describe.each(files)('%s', (file) => {
  it('is a project that can be kept, and the same file again', () => {
    const text = textOf(file)
    const project = projectFrom(text, 'x', garden)
    expect(parseProject(writeProject(project))).toEqual(project)
    expect(xmlTree(fileFrom(project, 'bo'))).toEqual(xmlTree(text))
  })
})

describe('the robot of a file', () => {
  const empty: Program = { stacks: [], config: { stacks: [] } }
  const eyes: RobotConfig = {
    ...cardConfig,
    drive: { left: 'A', right: 'D' },
    wheelDiameter: 4.3,
    trackWidth: 12,
  }

  it('is the one out of the box where the file says so, and where it says nothing', () => {
    expect(
      robotIn(projectFrom(textOf('composed__common__assign.xml'), 'x', garden).programs['main']!.config),
    ).toEqual(defaultConfig)
    expect(robotIn(empty.config)).toEqual(defaultConfig)
  })

  it.each([
    ['out of the box', defaultConfig],
    ['of the cards', cardConfig],
    ['of another build', eyes],
    ['without any sensor', { ...eyes, sensors: {} }],
  ])('%s: comes back as it was built', (_, robot) => {
    expect(robotIn(withRobot(empty, robot).config)).toEqual(robot)
    expect(robotIn(withRobot(withRobot(empty, defaultConfig), robot).config)).toEqual(robot)
  })

  it('has two eyes as on the cards where its file has two', () => {
    const text = readFileSync(new URL('../thesis/friendship.xml', folder), 'utf8')
    expect(robotIn(readOpenRoberta(text).config)).toEqual(cardConfig)
  })

  it('keeps what this robot has no word for', () => {
    const program = readOpenRoberta(textOf('upstream__xNN__sensors_ht.xml'))
    const brick = program.config.stacks[0]!.blocks[0]!
    const types = Object.values(brick.values!).map(({ type }) => type)
    const moved = withRobot(program, { ...robotIn(program.config), trackWidth: 11 })
    const after = moved.config.stacks[0]!.blocks[0]!
    expect(Object.values(after.values!).map(({ type }) => type)).toEqual(expect.arrayContaining(types))
    expect(after.fields!['TRACK_WIDTH']).toBe('11')
  })

  it('is not taken from numbers that make no sense', () => {
    const brick = (fields: { [name: string]: string }, data = 'x') => ({
      ...{ id: 'b', type: 'robBrick_EV3-Brick', fields },
      values: { S1: { id: 's', type: 'robBrick_touch', data } },
    })
    const robot = (block: ReturnType<typeof brick>) => robotIn({ stacks: [{ x: 0, y: 0, blocks: [block] }] })
    const odd = robot(brick({ WHEEL_DIAMETER: '-1', TRACK_WIDTH: '1e9' }, '{"x":1e9,"y":0,"angle":0}'))
    expect(odd).toMatchObject({
      wheelDiameter: 5.6,
      trackWidth: 18,
      sensors: { 1: defaultConfig.sensors[1] },
    })
  })
})

it('a card’s solution keeps its robot and its weights on the way through a file', () => {
  const project = {
    ...(read(`${card}/solution.json`) as Project),
    world: read('worlds/friendship/world.json') as World,
  }
  const back = projectFrom(fileFrom(project, 'bo'), 'x', project.world)
  expect(back.brains).toEqual(project.brains)
  expect(back.world.robots[0]!.config).toEqual(project.world.robots[0]!.config)
})

it('weights that were set back do not come back out of a file', () => {
  const world = read('worlds/friendship/world.json') as World
  const project = { ...(read(`${card}/solution.json`) as Project), world }
  const text = fileFrom(project, 'bo')
  const once = projectFrom(text, 'x', world)
  expect(projectFrom(fileFrom({ ...once, brains: {} }, 'bo'), 'x', world).brains).toEqual({})
})
