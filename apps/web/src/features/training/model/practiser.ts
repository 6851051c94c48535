import { learner } from '@botgarten/learning/neural-network'
import { beginExercise, prepare, type Exercise } from '@botgarten/learning/neural-network/examples'
import {
  pointOf,
  sleepingIn,
  stepSome,
  type CurvePoint,
  type Practice,
  type Settings,
  type TrainTrace,
} from '@botgarten/learning/neural-network/train'
import type { Example, Progress } from './messages.ts'

/** Of long practice not every round is measured. */
const mostPoints = 1000
/** So many examples pass before the clock is looked at. */
const examplesPerLook = 64

/** One practice, done in slices: the same weights bit for bit, however it is sliced. */
export class Practiser {
  readonly #job: number
  readonly #practice: Practice
  #points: CurvePoint[] = []
  #stored: Float64Array[] = []
  #until = 0
  #pace = Infinity
  #began = { at: 0, round: 0 }

  /** @throws RangeError as `beginPractice` does */
  constructor(job: number, exercise: Exercise, settings: Settings) {
    this.#job = job
    this.#practice = beginExercise(prepare(exercise), settings, exercise)
    this.#measure()
  }

  get isDone(): boolean {
    return this.#practice.ended !== null || this.#practice.round >= this.#until
  }

  /** Practises to the end of round `until`. @param now ms */
  go(until: number, pace: number, now: number): void {
    this.#until = until
    this.#pace = pace
    this.#began = { at: now, round: this.#practice.round }
  }

  stop(): void {
    this.#until = this.#practice.round
  }

  /** Milliseconds until the next round may begin; 0: at once. */
  wait(now: number): number {
    const { at, round } = this.#began
    const done = this.#practice.round - round
    return Math.max(0, at + (1000 * done) / this.#pace - now)
  }

  /** Works until `end` (ms), or until there is nothing to do yet. */
  work(clock: () => number, end: number): void {
    while (!this.isDone && this.wait(clock()) === 0) {
      this.#examples()
      if (clock() >= end) return
    }
  }

  /** Some examples, at most to the end of the round. */
  #examples(): void {
    const practice = this.#practice
    const { round } = practice
    let done = 0
    while (done < examplesPerLook && practice.round === round && !practice.ended) done += stepSome(practice)
    if (practice.round === round && !practice.ended) return
    const every = Math.ceil(this.#until / mostPoints)
    if (practice.round % every === 0 || this.isDone) this.#measure()
  }

  #measure(): void {
    const { parameters } = this.#practice
    const point = pointOf(this.#practice)
    if (this.#points.at(-1)?.round === point.round) return
    this.#points.push(point)
    this.#stored.push(parameters.slice())
  }

  get hasNews(): boolean {
    return this.#points.length > 0
  }

  /** Has a round that nobody was told of passed since it was asked to go? */
  get hasMoved(): boolean {
    return this.hasNews && this.#practice.round > this.#began.round
  }

  /** What has come since the last report. */
  report(): Progress {
    const practice = this.#practice
    const { round, ended, parameters, whole } = practice
    const isGoing = !this.isDone
    const points = this.#points
    const stored = new Float64Array(points.length * parameters.length)
    this.#stored.forEach((one, at) => stored.set(one, at * parameters.length))
    this.#points = []
    this.#stored = []
    const now = (ended ? parameters : whole).slice()
    const sleeping = isGoing ? [] : sleepingIn(practice)
    return { kind: 'progress', job: this.#job, round, points, stored, now, isGoing, ended, sleeping }
  }

  /** Opens the next example; with `peek` nothing has happened afterwards. Null where practice is over. */
  example(isPeek: boolean): Example | null {
    const practice = this.#practice
    const saved = isPeek ? learner.save(practice) : null
    let trace: TrainTrace | null = null
    const { round } = practice
    learner.step(practice, (one) => (trace = one))
    if (saved) learner.restore(practice, saved)
    else if (practice.round !== round) this.#measure()
    if (!trace) return null
    const now = practice.parameters.slice()
    return { kind: 'example', job: this.#job, trace, isPeek, now }
  }
}
