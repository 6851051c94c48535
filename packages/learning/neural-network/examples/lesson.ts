import { withWeights } from '../edit.ts'
import { blockFor } from '../train/block.ts'
import { lossOf, meanLoss, percentOff, rightRows, type Measured } from '../train/errors.ts'
import { forwardOver } from '../train/forward.ts'
import { layOutTraining, parametersIn, sharesIn, weightsIn } from '../train/layout.ts'
import { beginCurve, type CurvePoint } from '../train/practise.ts'
import { rowsOf, type Pair } from '../train/rows.ts'
import type { Practice, Settings } from '../train/types.ts'
import type { Brain, PracticeNote, Weights } from '../types.ts'
import { beginExercise, prepare, type Exercise, type Prepared } from './prepare.ts'
import { shownPairs } from './rows.ts'
import type { Examples } from './types.ts'

/** Practice on its way, with what it began from. It goes on by `practiseFor`. */
export interface Lesson {
  readonly exercise: Exercise
  readonly settings: Settings
  readonly prepared: Prepared
  readonly practice: Practice
  readonly curve: CurvePoint[]
}

/** @throws RangeError as `beginPractice` does */
export function beginLesson(exercise: Exercise, settings: Settings, prepared = prepare(exercise)): Lesson {
  const practice = beginExercise(prepared, settings, exercise)
  return { exercise, settings, prepared, practice, curve: beginCurve(practice) }
}

/** The brain with what a lesson has come to, in a weight set, and how it came about. */
export function afterLesson(brain: Brain, lesson: Lesson, set = ''): Brain {
  const { exercise, practice } = lesson
  const weights = weightsIn(practice.net, practice.parameters, exercise.weights)
  return { ...withWeights(brain, weights, set), practice: noteOf(lesson) }
}

function noteOf({ exercise, settings, prepared, practice, curve }: Lesson): PracticeNote {
  const { seed, keepBack, from, mirror } = exercise
  return {
    ...{ seed, start: prepared.data.weights, round: practice.round, curve, marks: [] },
    settings: { ...settings, keepBack, from, mirror: mirror !== null },
  }
}

/**
 * How far a network is off all its examples that are on, in percent: the root of the mean square; with `choice` the share of
 * rows that are wrong. Null: there are none, or the network has no outputs.
 */
export function errorOn(
  layers: Brain['layers'],
  weights: Weights,
  examples: Examples,
  choice: 'one' | 'each' | null,
): number | null {
  const ids = (layer: Brain['layers'][number] = []) => layer.map(({ id }) => id)
  const outputs = ids(layers.at(-1))
  const { pairs } = shownPairs(examples, ids(layers[0]), outputs)
  if (pairs.length === 0 || outputs.length === 0) return null
  const rows = rowsOf(pairs)
  return choice === null
    ? percentOff(meanLoss(measuredBy(layers, weights), rows)!)
    : 100 * (1 - rightIn(layers, weights, pairs, choice) / rows.count)
}

/** How many of these examples a network has right: see `rightRows`. */
export const rightIn = (
  layers: Brain['layers'],
  weights: Weights,
  pairs: readonly Pair[],
  choice: 'one' | 'each',
): number => rightRows(measuredBy(layers, weights), rowsOf(pairs), choice)

/** By example: the mean of the squares by which the network is off, in hundredths. */
export function lossesOn(
  layers: Brain['layers'],
  weights: Weights,
  pairs: readonly Pair[],
): readonly number[] {
  const [measured, rows] = [measuredBy(layers, weights), rowsOf(pairs, { shares: sharesIn(layers) })]
  return pairs.map((_, row) => {
    forwardOver(measured, rows.inputs, row)
    return lossOf(measured, rows, row)
  })
}

/** Outputs that share 100 too are measured by how far they are off. */
function measuredBy(layers: Brain['layers'], weights: Weights): Measured {
  const net = layOutTraining(layers)
  const [sums, values] = [new Float64Array(net.count), new Float64Array(net.count)]
  const parameters = parametersIn(net, weights)
  return { net: { ...net, shares: false }, parameters, sums, values, block: blockFor(net) }
}
