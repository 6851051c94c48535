import {
  columnsFor,
  hasRoom,
  mostOf,
  noExamples,
  withRow,
  type Drive,
  type Examples,
} from '@botgarten/learning/neural-network/examples'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Simulation } from '@botgarten/simulation'
import { heldBy, type Hands } from '../inputs/hands.ts'
import type { Brains } from '../robots/brains.ts'
import type { RobotRun } from '../robots/run.ts'
import { poseIn } from '../timeline/moment.ts'
import type { Recording } from '../inputs/input.ts'
import { doneOutputs, heldOutputs, networkOf, readInputs, type Columns } from './columns.ts'

/** Where rows come from: one moment of a run. */
export interface Recorder {
  readonly simulation: Simulation
  readonly robots: readonly RobotRun[]
  readonly brains: Brains
  readonly tick: number
}

/** The table of a network, with a column for each of its neurons. */
function tableOf(brain: Brain): Examples {
  const ids = (layer: Brain['layers'][number] = []) => layer.map(({ id }) => id)
  const [inputs, outputs] = [ids(brain.layers[0]), ids(brain.layers.at(-1))]
  return brain.examples ? columnsFor(brain.examples, inputs, outputs) : noExamples(inputs, outputs)
}

/** Is there no room for another row, in the network's table or in the project? */
export function isFull(brains: Brains, network: string, drive: string): boolean {
  const rows = Object.values(brains).reduce((sum, brain) => sum + (brain.examples?.rows.length ?? 0), 0)
  const examples = brains[network]?.examples
  return rows >= mostOf.projectRows || (examples !== undefined && !hasRoom(examples, drive))
}

/** The row that a recording writes in this tick (running.md 14, 15); null: none. */
export function recorded(recorder: Recorder, recording: Recording, hands: Hands): Brain | null {
  const { robot: index, network, every, drive } = recording
  if (recorder.tick % every !== 0) return null
  const robot = recorder.robots[index]
  const outline = robot && networkOf(robot, network)
  if (!outline) return null
  const inputs = readInputs(robot, outline)
  const write = (outputs: Columns) => withExample(recorder, recording, inputs, outputs)
  if (drive.by === 'program')
    return write(doneOutputs(robot, outline, recorder.simulation.state.robots[index]!))
  const wheels = heldBy(hands, index)
  if (!wheels) return null
  const { config } = recorder.simulation.world.robots[index]!
  const others = hands.hand?.robot === index ? hands.hand.others : {}
  return write(heldOutputs(robot, outline, config.drive, wheels, others))
}

interface Into {
  readonly robot: number
  readonly network: string
  readonly drive: Drive
}

/** The network's brain with one example more. Null where nothing is written: it repeats the one before, or there is no room. */
export function withExample(
  { simulation, brains, tick }: Recorder,
  { robot, network, drive }: Into,
  inputs: Columns,
  outputs: Columns,
): Brain | null {
  const brain = brains[network]
  const pose = poseIn(simulation.state.robots[robot])
  if (!brain || !pose || isFull(brains, network, drive.id)) return null
  const before = tableOf(brain)
  const examples = withRow(before, drive, { tick, pose, inputs, outputs })
  return examples === before ? null : { ...brain, examples }
}
