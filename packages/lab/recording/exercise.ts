import { weightsOf } from '@botgarten/learning/neural-network/brain'
import {
  exerciseBy,
  practiceChoice,
  prepare,
  type Exercise,
} from '@botgarten/learning/neural-network/examples'
import { obstacleTo, type Obstacle } from '@botgarten/learning/neural-network/train'
import { mirrorIn } from '@botgarten/programs/examples'
import { networkOf } from './columns.ts'
import type { Recorder } from './recorder.ts'

/** What a robot's network practises when a program asks for it: on from the weights the robot drives with. Null: it has no examples. */
export function exerciseOf(
  { robots, simulation, brains }: Recorder,
  index: number,
  network: string,
): Exercise | null {
  const [robot, brain, placement] = [robots[index], brains[network], simulation.world.robots[index]]
  const outline = robot && networkOf(robot, network)
  if (!outline || !placement || !brain?.examples) return null
  const { layers, examples } = brain
  const shown = { id: network, layers, examples, weights: weightsOf(brain, placement.brain) }
  const mirror = mirrorIn(outline, placement.config)
  return { ...exerciseBy(practiceChoice(brain), shown, mirror), from: 'knobs' }
}

const problems: { readonly [kind in Obstacle['kind']]: string } = {
  noLinks: 'practiseNoLinks',
  threshold: 'practiseThreshold',
  softmax: 'practiseSoftmax',
  none: 'practiseNone',
}

/** Why a network cannot practise: its problem's name in the words, or null. */
export function problemOf(exercise: Exercise | null): string | null {
  if (!exercise) return 'noExamples'
  const { data } = prepare(exercise)
  if (data.practised.count === 0) return 'noExamples'
  const obstacle = obstacleTo(data)
  return obstacle && problems[obstacle.kind]
}
