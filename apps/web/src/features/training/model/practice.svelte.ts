import { beginningOfExercise, exerciseBy, type Table } from '@botgarten/learning/neural-network/examples'
import type { Change, LabEvent } from '#lab/change.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { Assignment } from './assignment.svelte.ts'
import { Beats } from './beats.svelte.ts'
import { Engine } from './engine.ts'
import type { Answer, Order, Phase, Progress, Report, Then } from './messages.ts'
import { Outcome } from './outcome.svelte.ts'
import {
  isSamePractice,
  mostRounds,
  nearestRound,
  noteOf,
  parametersIn,
  Rehearsal,
  weightsAt,
} from './rehearsal.ts'

/** Practice stops for these. */
const stopping: readonly Change['kind'][] = ['blocks', 'program', 'examples', 'robots', 'brain', 'weight']

/** How the network on the screen practises its examples: what a child does with rounds, and what has come of it. */
export class Practice extends Assignment {
  readonly beats: Beats
  readonly #engine = new Engine((report) => this.#hear(report))
  #phase = $state<Phase>('rest')
  /** A hand wants it to rest; the last whole round is on its way. */
  #isPausing = $state(false)
  readonly outcome = new Outcome()
  /** Rounds a second; Infinity: as fast as it can. */
  pace = $state(Infinity)
  /** What the rounds follow from; null: nothing was practised yet, or a hand has turned knobs since. */
  #rehearsal: Rehearsal | null = null
  #job = 0
  /** The round up to which the engine has practised; −1: it has not begun with this. */
  #reached = -1
  #then: Then | null = null
  /** Milliseconds at which it began to practise. */
  #began = 0
  #answer: (answer: Answer) => void = () => {}

  constructor(session: LabSession) {
    super(session)
    this.beats = new Beats(this)
    this.#adopt()
    session.listen((event) => this.#heed(event))
    session.settles((change) => this.#settle(change))
  }

  get phase() {
    return this.#phase
  }
  get isGoing() {
    return this.#phase === 'going'
  }
  /** Does it rest, or will it as soon as its last round is here? */
  get rests() {
    return this.#phase === 'rest' || this.#isPausing
  }
  /** Practises as many rounds as are chosen, from the round that is shown on. */
  practise(): void {
    if (this.obstacle || this.#phase !== 'rest') return
    this.beats.close()
    this.#begin({ kind: 'go' })
  }

  /** Does what comes next with a practice that stands at the round that is shown. */
  #begin(then: Then): void {
    this.knobs.hold()
    if (!this.#rehearsal || !this.#goesOn(this.#rehearsal)) this.#reset()
    if (this.#reached === this.outcome.round) return this.#now(then)
    this.#again(then, this.outcome.round)
  }

  /** Is what practises next the same practice, with the weights that it has left? */
  #goesOn({ exercise, settings }: Rehearsal): boolean {
    const next = this.exercise(exercise.weights)
    return next !== null && this.knobs.stands && isSamePractice({ exercise, settings }, next, this.choice)
  }

  /** A practice of its own begins with the knobs as they are, or from zero. */
  #reset(): void {
    const exercise = this.exercise(this.knobs.weights)!
    const { shaken, weights } = beginningOfExercise(exercise)
    this.#rehearsal = new Rehearsal({ ...exercise, weights, from: 'knobs' }, this.choice)
    this.#rehearsal.from = exercise.from
    this.outcome.begin(shaken)
    this.#sendBegin()
    this.#reached = 0
  }

  #sendBegin(): void {
    const { exercise, settings } = this.#rehearsal!
    this.#job++
    this.#send({ kind: 'begin', job: this.#job, exercise, settings: { ...settings, rounds: mostRounds } })
  }

  #send(order: Order): void {
    this.#engine.send(order)
  }

  /** Practises again what was practised: the same every time. */
  #again(then: Then, until: number): void {
    this.#sendBegin()
    this.#reached = -1
    this.#then = then
    this.#phase = 'again'
    this.#send({ kind: 'go', until, pace: Infinity })
  }

  #now(then: Then): void {
    this.#then = null
    if (then.kind === 'open') return this.#send({ kind: 'peek' })
    if (then.kind === 'show') return this.#show(then.round)
    this.outcome.goOn()
    this.#phase = 'going'
    this.#began = performance.now()
    const until = Math.min(mostRounds, this.outcome.round + this.choice.settings.rounds)
    this.#send({ kind: 'go', until, pace: this.pace })
  }

  /** It is about to be asked: what practises is there then. */
  warm = () => this.#engine.warm()

  pause(): void {
    if (this.#phase === 'again') this.#then = null
    if (this.#phase === 'rest') return
    this.#isPausing = true
    this.#send({ kind: 'stop' })
  }

  /** Has a large table looked through beside the page. */
  ask(number: number, table: Table, answer: (answer: Answer) => void): void {
    this.#answer = answer
    this.#send({ kind: 'ask', number, table })
  }

  #hear(report: Report): void {
    if (report.kind === 'answer') return this.#answer(report)
    setTimeout(() => this.#send({ kind: 'heard' }))
    if (report.job !== this.#job || !this.#rehearsal) return
    if (report.kind === 'example') return this.beats.take(report)
    this.#rehearsal.keep(report)
    this.#reached = report.round
    if (this.#phase === 'again') return this.#hearAgain(report)
    if (this.beats.trace) this.outcome.show(report.round)
    this.outcome.measure(report.points)
    if (this.#phase === 'going') this.#hearRounds(report)
  }

  #hearAgain({ isGoing }: Progress): void {
    if (isGoing) return
    this.#isPausing = false
    this.#phase = 'rest'
    const then = this.#then
    if (then) this.#now(then)
  }

  #hearRounds({ now, round, isGoing, ended, sleeping }: Progress): void {
    if (isGoing && this.#isPausing) return
    this.outcome.show(ended?.kind === 'noBetter' ? ended.best : round)
    this.write(now)
    if (isGoing) return
    this.#isPausing = false
    this.#phase = 'rest'
    this.outcome.end(ended ?? (round > 0 ? { kind: 'rounds' } : null), sleeping)
    if (ended) this.#reached = -1
    this.session.effort.computed((performance.now() - this.#began) / 1000)
    this.commit()
  }

  /** Puts parameters on the knobs; `commit` makes one step of it. */
  write(parameters: Float64Array): void {
    if (this.#rehearsal) this.knobs.write(weightsAt(this.#rehearsal, parameters, this.knobs.weights))
  }

  /** One undo brings the weights of before back. */
  commit(): void {
    const rehearsal = this.#rehearsal
    if (!rehearsal) return
    this.knobs.commit(() => noteOf(rehearsal, this.outcome))
  }

  /** Shows the network as it was after a round. `done`: the hand lets go of the curve. */
  goTo(round: number, done: boolean): void {
    if (this.#phase === 'going' || !this.#rehearsal || !this.net) return
    this.beats.close()
    const nearest = nearestRound(this.outcome.curve, round)
    if (this.#rehearsal.at(nearest)) this.#show(nearest)
    else if (this.#phase === 'rest') this.#again({ kind: 'show', round: nearest }, this.outcome.last)
    else this.#then = { kind: 'show', round: nearest }
    if (done && this.#phase === 'rest') this.commit()
  }

  #show(round: number): void {
    const parameters = this.#rehearsal?.at(round)
    if (!parameters) return
    this.outcome.show(round)
    this.write(parameters)
  }

  /** Opens one example. */
  open(): void {
    if (this.obstacle || this.#phase !== 'rest') return
    this.#begin({ kind: 'open' })
  }

  peek = () => this.#send({ kind: 'peek' })
  take = () => this.#send({ kind: 'step' })

  /** Resets practice to weights of zero, or to random ones where there are hidden neurons. */
  fromZero(): void {
    const exercise = this.exercise(this.knobs.weights)
    if (!exercise || this.obstacle || this.#phase !== 'rest') return
    this.beats.close()
    this.knobs.hold()
    const { weights } = beginningOfExercise({ ...exercise, from: 'zero' })
    this.#rehearsal = new Rehearsal({ ...exercise, weights, from: 'knobs' }, this.choice)
    this.outcome.begin(false)
    this.outcome.end(null)
    this.#sendBegin()
    this.#reached = 0
    this.write(parametersIn(this.#rehearsal))
    this.commit()
  }

  #heed(event: LabEvent): void {
    if (event.kind === 'begun') return this.#markDrive()
    if (event.kind !== 'changed' || this.knobs.isOwn) return
    const { change } = event
    if (change.kind === 'brain' || change.kind === 'future') this.#byHand()
    else if (change.kind === 'program' || change.kind === 'examples' || change.kind === 'robots')
      this.interrupt()
  }

  /** Something else is about to become a step: the rounds so far are one before it. */
  #settle(change: Change | null): void {
    if (!this.knobs.isOwn && (change === null || stopping.includes(change.kind))) this.interrupt()
  }

  /** Something else has changed the weights: a knob, or undo. */
  #byHand(): void {
    this.interrupt()
    if (!this.knobs.isOther) return
    this.#adopt()
  }

  /** Comes to rest at once: something else has the knobs, or is about to. */
  interrupt(): void {
    this.beats.close()
    if (this.#phase === 'rest') return
    this.#send({ kind: 'stop' })
    this.#job++
    this.#reached = -1
    this.#isPausing = false
    this.#phase = 'rest'
    this.commit()
  }

  /** Takes up what the project says of practice before. */
  #adopt(): void {
    const { note, examples } = this
    this.knobs.forget()
    this.#reached = -1
    this.outcome.adopt(note)
    this.#rehearsal = null
    if (!note || note.round === 0 || !examples || !this.net) return
    const shown = { id: this.net.id, layers: this.layers, weights: note.start, examples }
    this.#rehearsal = Rehearsal.of(note, { ...exerciseBy(note, shown, this.mirror), from: 'knobs' })
    this.knobs.take()
  }

  /** Bo drives with this round. */
  #markDrive(): void {
    const { net } = this
    const note = this.note
    if (!net || !note || !this.outcome.mark()) return
    const after = { ...note, marks: this.outcome.marks }
    this.knobs.as(() => this.session.apply({ kind: 'practice', network: net.id, after }, 'silent'))
  }

  close(): void {
    this.#engine.close()
  }
}
