import type { World } from '@botgarten/simulation'
import type { Project } from '../types.ts'
import { brainsIn, withBrains } from './brains.ts'
import { robotIn, withRobot } from './brick.ts'
import { readOpenRoberta } from './read.ts'
import { writeOpenRoberta } from './write.ts'

/**
 * An Open Roberta file as a project: its program drives the first robot of `world`, built as its configuration says.
 * @throws {ProjectError} and nothing else
 */
export function projectFrom(text: string, name: string, world: World): Project {
  const program = readOpenRoberta(text)
  const config = robotIn(program.config)
  const robots = world.robots.slice(0, 1).map((robot) => ({ ...robot, program: 'main', brain: '', config }))
  return {
    ...{ botgarten: 1, name, programs: { main: program }, brains: brainsIn(program) },
    world: { ...world, robots },
    assets: {},
  }
}

/** One robot of a project as an Open Roberta file: its program, how it is built, the weights on its knobs. */
export function fileFrom(
  { programs, world, brains }: Pick<Project, 'programs' | 'world' | 'brains'>,
  robotId: string,
) {
  const robot = world.robots.find(({ id }) => id === robotId) ?? world.robots[0]
  const program = robot && programs[robot.program]
  if (!program) throw new RangeError(`There is no robot "${robotId}" with a program.`)
  return writeOpenRoberta(withBrains(withRobot(program, robot.config), brains))
}
