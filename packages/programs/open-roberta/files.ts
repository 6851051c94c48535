import type { World } from '@botgarten/simulation'
import { refusalOf } from '../project/refusal.ts'
import type { Project } from '../types.ts'
import { brainsIn, withBrains } from './brains.ts'
import { robotIn, withRobot } from './brick.ts'
import { strangersIn, type Kin } from './known.ts'
import { inSteps, type Unsaid } from './network-steps.ts'
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
  const project: Project = {
    ...{ botgarten: 1, name, programs: { main: program }, brains: brainsIn(program) },
    world: { ...world, robots },
    assets: {},
  }
  // What opens can be saved as well.
  const refusal = refusalOf(project)
  if (refusal) throw refusal
  return project
}

type Out = Pick<Project, 'programs' | 'world' | 'brains'>

function driven({ programs, world }: Out, robotId: string) {
  const robot = world.robots.find(({ id }) => id === robotId) ?? world.robots[0]
  const program = robot && programs[robot.program]
  if (!program) throw new RangeError(`There is no robot "${robotId}" with a program.`)
  return { robot, program }
}

/** One robot of a project as an Open Roberta file: its program, how it is built, the weights on its knobs. */
export function fileFrom(project: Out, robotId: string): string {
  const { robot, program } = driven(project, robotId)
  return writeOpenRoberta(withBrains(withRobot(program, robot.config), project.brains))
}

/** What today's Open Roberta does not know of a robot's program, and whether its network can be said in blocks that it knows. */
export function strangeness(
  project: Out,
  robotId: string,
): { readonly kin: readonly Kin[]; readonly network: 'steps' | Unsaid | null } {
  const { robot, program } = driven(project, robotId)
  const kin = strangersIn(program)
  if (!kin.includes('network')) return { kin, network: null }
  const steps = inSteps(program, project.brains, robot.brain)
  return { kin, network: typeof steps === 'string' ? steps : 'steps' }
}

/** The same file with the network in Open Roberta's own blocks, where it can be said in them. */
export function fileInSteps(project: Out, robotId: string): string {
  const { robot, program } = driven(project, robotId)
  const steps = inSteps(program, project.brains, robot.brain)
  if (typeof steps === 'string') throw new RangeError(`The network cannot be said in steps: ${steps}.`)
  return writeOpenRoberta(withRobot(steps, robot.config))
}
