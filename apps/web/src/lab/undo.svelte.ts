import type { Change, LabEvent, Part } from './change.ts'

/** One step over the project: what does it again, and what takes it back. */
interface Step {
  readonly change: Change
  readonly back: Change
  /** Goes together with the step before it. */
  readonly joined?: boolean
}

/** What a stack asks of the session it listens to. */
interface Host {
  /** @returns whether it happened: not while a hand holds a block */
  apply(change: Change, part: Part): boolean
  /** Is there still another future? */
  hasFuture(): boolean
  /** Tick of the present run. */
  now(): number
  /** What is under way becomes a step of its own first. */
  settle(): void
}

/** Takes back only what one of two children has done. */
export interface OwnSteps {
  readonly canUndo: boolean
  readonly canRedo: boolean
  undo(): void
  redo(): void
}

const LONGEST = 500
const future: Step = { change: { kind: 'future' }, back: { kind: 'future' } }
/** Changes that end the timeline, and every other future with it. */
const ending: readonly Change['kind'][] = ['blocks', 'scene', 'config']

/** One stack over blocks, world and weights (running.md 9). */
export class UndoStack {
  #done = $state.raw<readonly Step[]>([])
  #undone = $state.raw<readonly Step[]>([])
  #host: Host
  /** Who knows the own steps where another child edits, too. */
  #lent = $state.raw<OwnSteps | null>(null)
  /** When steps were done: the tick of the present run. */
  #at = new WeakMap<Step, number>()
  /** What was done in the other future. */
  #elsewhere: readonly Step[] = []

  constructor(host: Host) {
    this.#host = host
  }

  get canUndo() {
    if (this.#lent) return this.#lent.canUndo
    return this.#done.some(this.#stands)
  }
  get canRedo() {
    if (this.#lent) return this.#lent.canRedo
    return this.#undone.some(this.#stands)
  }

  #stands = (step: Step): boolean => step !== future || this.#host.hasFuture()

  /** How many steps can be taken back, for who joins one to what came before it. */
  get count() {
    return this.#done.length
  }

  /** Lets somebody else take steps back, until null: what was done before that is a step no longer. */
  lend(to: OwnSteps | null): void {
    this.#lent = to
    this.#done = []
    this.#undone = []
  }

  hear = (event: LabEvent): void => {
    if (event.kind === 'branched') this.#branch(event.tick)
    // What was done before a run belongs to no moment of it.
    else if (event.kind === 'begun') this.#at = new WeakMap()
    else if (event.back) this.#note({ ...event, back: event.back })
  }

  /** The other future stays to come back, whatever else is done in this one (running.md 9). */
  #note({ change, back, joined }: Step): void {
    const kept = ending.includes(change.kind) ? [] : [future].filter((one) => this.#undone.includes(one))
    const step: Step = { change, back, joined: joined ?? false }
    this.#at.set(step, this.#host.now())
    this.#done = [...this.#done, step].slice(-LONGEST)
    this.#undone = kept
  }

  /** What was done after the tick comes back with the other future. */
  #branch(tick: number): void {
    const done = this.#done.filter((step) => step !== future)
    this.#elsewhere = done
    this.#done = done.filter((step) => (this.#at.get(step) ?? -1) < tick)
    this.#undone = [future]
  }

  undo(): void {
    if (this.#lent) return this.#lent.undo()
    this.#host.settle()
    this.#forgetFuture()
    const step = this.#done.at(-1)
    if (!step || !this.#host.apply(step.back, 'silent')) return
    this.#done = this.#done.slice(0, -1)
    if (step === future) [this.#done, this.#elsewhere] = [this.#elsewhere, this.#done]
    this.#undone = [...this.#undone, step]
    if (step.joined) this.undo()
  }

  redo(): void {
    if (this.#lent) return this.#lent.redo()
    this.#host.settle()
    this.#forgetFuture()
    const step = this.#undone.at(-1)
    if (!step || !this.#host.apply(step.change, 'silent')) return
    this.#undone = this.#undone.slice(0, -1)
    if (step === future) [this.#done, this.#elsewhere] = [this.#elsewhere, this.#done]
    this.#done = [...this.#done, step]
    if (this.#undone.at(-1)?.joined) this.redo()
  }

  #forgetFuture(): void {
    if (this.#host.hasFuture()) return
    this.#done = this.#done.filter(this.#stands)
    this.#undone = this.#undone.filter(this.#stands)
    this.#elsewhere = []
  }
}
