import type { Brain } from '@botgarten/learning/neural-network'
import { afterLesson, beginLesson, prepare, type Exercise } from '@botgarten/learning/neural-network/examples'
import {
  byHeartSince,
  obstacleTo,
  practiseFor,
  sleepingIn,
  type CurvePoint,
  type Obstacle,
  type Settings,
} from '@botgarten/learning/neural-network/train'
import { addToHash, hex, startHash } from '@botgarten/numbers'
import { FileError } from '../errors.ts'
import { message } from '../words.ts'

/** Practises to the end. @throws {FileError} where there is nothing to practise, or the network cannot */
export function practised(exercise: Exercise, settings: Settings, brain: Brain) {
  const prepared = prepare(exercise)
  if (prepared.data.practised.count === 0) throw new FileError('examples.noRows')
  const obstacle = obstacleTo(prepared.data)
  if (obstacle) throw new FileError('examples.cannot', { why: obstacleSaid(obstacle) })
  const lesson = beginLesson(exercise, settings, prepared)
  const { practice, curve } = lesson
  practiseFor(practice, curve, Infinity)
  const after = { ...afterLesson(brain, lesson), examples: exercise.examples }
  return {
    ...{ prepared, practice, curve, weights: after.weights, last: lastOf(curve, practice.round) },
    ...{ sleeping: sleepingIn(practice), byHeart: byHeartSince(curve) },
    ...{ brain: after, hash: hashOf(practice.parameters) },
  }
}

/** The errors of the weights that it ended with: those of the best round where it went back to one. */
const lastOf = (curve: readonly CurvePoint[], round: number) =>
  curve.findLast((point) => point.round === round) ?? curve.at(-1)!

/** 64 bits over the weights and biases, layer by layer (float64). */
function hashOf(parameters: Float64Array): string {
  const hash = startHash()
  for (const value of parameters) addToHash(hash, value)
  return hex(hash)
}

function obstacleSaid(obstacle: Obstacle): string {
  if (obstacle.kind === 'threshold')
    return message('examples.threshold', { neurons: obstacle.neurons.join(', ') })
  if (obstacle.kind === 'none') return message('examples.none', { row: obstacle.row + 1 })
  return message(`examples.${obstacle.kind}`)
}
