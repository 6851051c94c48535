import type { PracticeNote, Weights } from '@botgarten/learning/neural-network'
import { stepSettings, type Exercise, type PracticeChoice } from '@botgarten/learning/neural-network/examples'
import {
  layOutTraining,
  parametersIn as laidOut,
  weightsIn,
  type CurvePoint,
  type Settings,
  type TrainNet,
} from '@botgarten/learning/neural-network/train'
import type { Progress } from './messages.ts'

/** A practice as it can be practised again: from its start, and what each of its rounds came to. */
export class Rehearsal {
  /** Begins with the weights of its start. */
  readonly exercise: Exercise
  readonly settings: Settings
  readonly net: TrainNet
  /** How its start came about. */
  from: 'knobs' | 'zero' = 'knobs'
  readonly #rounds = new Map<number, Float64Array>()

  constructor(exercise: Exercise, choice: PracticeChoice) {
    this.exercise = exercise
    this.settings = stepSettings(choice)
    this.net = layOutTraining(exercise.layers)
  }

  /** What a project says of it. */
  static of(note: PracticeNote, exercise: Exercise): Rehearsal {
    const one = new Rehearsal(exercise, note)
    one.from = note.settings.from
    return one
  }

  keep({ points, stored }: Progress): void {
    const { parameters } = this.net
    points.forEach(({ round }, at) => {
      this.#rounds.set(round, stored.subarray(at * parameters, (at + 1) * parameters))
    })
  }

  /** The parameters after a round, where they are known. */
  at = (round: number) => this.#rounds.get(round)
}

/** The parameters that it starts with. */
export const parametersIn = ({ net, exercise }: Rehearsal) => laidOut(net, exercise.weights)

/** The weights of parameters; links that the network does not have stay as in `others`. */
export const weightsAt = ({ net }: Rehearsal, parameters: Float64Array, others: Weights) =>
  weightsIn(net, parameters, others)

/** Would this exercise with this choice practise as that one has? How many rounds, plays no part. */
export function isSamePractice(
  { exercise, settings }: Pick<Rehearsal, 'exercise' | 'settings'>,
  next: Exercise,
  choice: PracticeChoice,
): boolean {
  const { rounds: _, ...own } = settings
  const { rounds: _other, ...other } = stepSettings(choice)
  return (
    exercise.id === next.id &&
    exercise.layers === next.layers &&
    exercise.examples === next.examples &&
    exercise.seed === next.seed &&
    exercise.keepBack === next.keepBack &&
    (exercise.mirror === null) === (next.mirror === null) &&
    JSON.stringify(own) === JSON.stringify(other)
  )
}

/** Of a curve a project holds so many points. */
const mostPoints = 1000

/** What the project says of it. */
export function noteOf(
  { exercise, settings, from }: Rehearsal,
  { round, curve, marks }: Pick<PracticeNote, 'round' | 'curve' | 'marks'>,
): PracticeNote {
  const { seed, keepBack, mirror, weights } = exercise
  const every = Math.ceil(curve.length / mostPoints)
  const thinned = curve.filter((_, at) => at % every === 0 || at === curve.length - 1)
  return {
    ...{ seed, start: weights, round, curve: thinned, marks: marks.slice(-mostPoints) },
    settings: { ...settings, keepBack, from, mirror: mirror !== null },
  }
}

/** A practice may go on so far. */
export const mostRounds = 100_000

/** The measured round that is nearest to this one. */
export function nearestRound(curve: readonly CurvePoint[], round: number): number {
  const off = (point: CurvePoint) => Math.abs(point.round - round)
  return curve.reduce((a, b) => (off(b) < off(a) ? b : a), curve[0]!).round
}
