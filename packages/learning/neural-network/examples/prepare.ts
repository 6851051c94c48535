import { stream } from '@botgarten/numbers'
import { sharesIn } from '../train/layout.ts'
import { beginningOf } from '../train/beginning.ts'
import { rowsOf, type Mirror } from '../train/rows.ts'
import { beginPractice } from '../train/state.ts'
import type { Practice, PracticeData, Settings } from '../train/types.ts'
import type { Brain, Weights } from '../types.ts'
import { shownPairs } from './rows.ts'
import { splitDrives, type Split } from './split.ts'
import type { Examples } from './types.ts'

/** What a network is to practise, and how its practice begins. */
export interface Exercise {
  /** Name of the network's block: its streams are named by it. */
  readonly id: string
  readonly layers: Brain['layers']
  readonly weights: Weights
  readonly examples: Examples
  readonly seed: number
  /** Share of the drives that is held back for a test. */
  readonly keepBack: number
  readonly from: 'knobs' | 'zero'
  /** Mirror images are practised too; null: not. */
  readonly mirror: Mirror | null
}

export interface Prepared extends Split {
  readonly data: PracticeData
  /** Were links that are all 0 shaken apart? */
  readonly shaken: boolean
  /** Rows that are on and have gaps: they do not practise. */
  readonly gaps: number
}

/** With which weights an exercise begins, without its examples. */
export const beginningOfExercise = ({ id, layers, weights, from, seed }: Exercise) =>
  beginningOf(layers, weights, from, stream(seed, `learn/start/${id}`))

/** Lays examples and beginning out; the same exercise gives the same, everywhere. */
export function prepare(exercise: Exercise): Prepared {
  const { layers, examples, seed, keepBack, mirror } = exercise
  const ids = (layer: Brain['layers'][number] = []) => layer.map((neuron) => neuron.id)
  const { pairs, gaps } = shownPairs(examples, ids(layers[0]), ids(layers.at(-1)))
  const split = splitDrives(pairs, examples.drives, seed, keepBack)
  const begun = beginningOfExercise(exercise)
  const shares = sharesIn(layers)
  const practised = rowsOf(split.practised, { mirror, shares })
  const kept = rowsOf(split.kept, { shares })
  return { ...split, gaps, shaken: begun.shaken, data: { layers, weights: begun.weights, practised, kept } }
}

/** @throws RangeError as `beginPractice` does */
export const beginExercise = ({ data }: Prepared, settings: Settings, { seed, id }: Exercise): Practice =>
  beginPractice(settings, data, stream(seed, `learn/order/${id}`))
