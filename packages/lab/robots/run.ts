import type { Context } from '@botgarten/blocks'
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
  readonly context: Context & { now: number }
  thread: Thread
}

const nothing: Program = { stacks: [], config: { stacks: [] } }

export function robotRun(
  simulation: Simulation,
  robot: number,
  programs: { readonly [id: string]: Program },
  brains: Brains,
): RobotRun {
  const placement = simulation.world.robots[robot]!
  const program = programs[placement.program] ?? nothing
  const index = indexProgram(program)
  const nets = new RobotBrains(placement, brains)
  const think = (id: string, inputs: readonly number[]) => nets.think(id, inputs)
  return {
    id: placement.id,
    program,
    index,
    networks: networks(program).map(({ id }) => id),
    brains: nets,
    context: { robot: robotOf(simulation, robot), now: 0, think },
    thread: startThread(index),
  }
}
