import type { Host, Mail } from '@botgarten/blocks'
import {
  indexProgram,
  networks,
  startThread,
  type Program,
  type ProgramIndex,
  type Thread,
} from '@botgarten/programs'
import type { Simulation } from '@botgarten/simulation'
import { RobotBrains, type Brains } from './brains.ts'
import { robotOf } from './robot.ts'

/** One robot's program and brains on their way. */
export interface RobotRun {
  readonly id: string
  readonly program: Program
  readonly index: ProgramIndex
  /** Network blocks of its program. */
  readonly networks: readonly string[]
  readonly brains: RobotBrains
  readonly context: Host & { now: number }
  thread: Thread
}

/** Robots of one run draw different numbers, and the same in every run with its seed. */
const seedOf = ({ state }: Simulation, robot: number): number => (state.noise[0] ?? 0) + robot

const nothing: Program = { stacks: [], config: { stacks: [] } }

export function robotRun(
  simulation: Simulation,
  robot: number,
  programs: { readonly [id: string]: Program },
  brains: Brains,
  mail: Mail,
  learningOf: (program: Program) => Pick<Host, 'teaching' | 'trying'>,
): RobotRun {
  const placement = simulation.world.robots[robot]!
  const program = programs[placement.program] ?? nothing
  const index = indexProgram(program)
  const nets = new RobotBrains(placement, brains)
  const context: RobotRun['context'] = {
    ...{ robot: robotOf(simulation, robot), now: 0, mail, ...learningOf(program) },
    think: (id, inputs) => nets.think(id, inputs, context.now),
    brain: (id) => nets.brain(id),
  }
  return {
    id: placement.id,
    program,
    index,
    networks: networks(program).map(({ id }) => id),
    brains: nets,
    context,
    thread: startThread(index, seedOf(simulation, robot)),
  }
}
