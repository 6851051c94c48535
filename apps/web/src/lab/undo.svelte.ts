import type { Document } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Scene } from '@botgarten/programs'
import type { Pose, RobotConfig } from '@botgarten/simulation'
import type { Poses } from './poses.ts'

/** One step over the document. Blocks are taken back by Blockly, which keeps what changed. */
export type Step =
  | { readonly kind: 'future' }
  | { readonly kind: 'blocks'; readonly program: string }
  /** Robots that came or went, with their programs and brains. `stood`: where everything stood before. */
  | { readonly kind: 'robots'; readonly before: Document; readonly after: Document; readonly stood: Poses }
  /** `start`: where a run that begins put it before. */
  | {
      readonly kind: 'place'
      readonly id: string
      readonly before: Pose
      readonly after: Pose
      readonly start?: Pose
    }
  | { readonly kind: 'brain'; readonly id: string; readonly before: Brain; readonly after: Brain }
  | ConfigStep
  | { readonly kind: 'scene'; readonly before: Scene; readonly after: Scene; readonly stood: Poses }

/** Another configuration of a robot. `joined`: goes together with the step before it. */
interface ConfigStep {
  readonly kind: 'config'
  readonly id: string
  readonly before: RobotConfig
  readonly after: RobotConfig
  readonly joined?: boolean
}

/** Who carries a step out, in either direction. */
export interface Hands {
  /** @returns whether it happened: not while a hand holds a block */
  blocks(direction: 'undo' | 'redo', program: string): boolean
  robots(document: Document, stood: Poses | undefined): void
  place(id: string, pose: Pose, start: Pose | undefined): void
  brain(id: string, brain: Brain): void
  /** Changes places with the other future (running.md 9). */
  future(): void
  /** Is there still another future? */
  hasFuture(): boolean
  /** Tick of the present run. */
  now(): number
  config(id: string, config: RobotConfig): void
  scene(scene: Scene, stood: Poses | undefined): void
}

const LONGEST = 500
const future: Step = { kind: 'future' }
/** Steps that end the timeline, and every other future with it. */
const ending: readonly Step['kind'][] = ['blocks', 'scene', 'config']

/** One stack over blocks, world and weights (running.md 9). */
export class UndoStack {
  #done = $state.raw<readonly Step[]>([])
  #undone = $state.raw<readonly Step[]>([])
  #hands: Hands
  /** When steps were done: the tick of the present run. */
  #at = new WeakMap<Step, number>()
  /** What was done in the other future. */
  #elsewhere: readonly Step[] = []

  constructor(hands: Hands) {
    this.#hands = hands
  }

  get canUndo() {
    return this.#done.some(this.#stands)
  }
  get canRedo() {
    return this.#undone.some(this.#stands)
  }

  #stands = (step: Step): boolean => step !== future || this.#hands.hasFuture()

  /** How many steps can be taken back, for who joins one to what came before it. */
  get count() {
    return this.#done.length
  }

  /** The other future stays to come back, whatever else is done in this one (running.md 9). */
  note(step: Step): void {
    const kept = ending.includes(step.kind) ? [] : [future].filter((one) => this.#undone.includes(one))
    this.#at.set(step, this.#hands.now())
    this.#done = [...this.#done, step].slice(-LONGEST)
    this.#undone = kept
  }

  /** A run begins: what was done before belongs to no moment of it. */
  begin(): void {
    this.#at = new WeakMap()
  }

  /** A hand went on from a tick of the past: what was done after it comes back with the other future. */
  branch(tick: number): void {
    const done = this.#done.filter((step) => step !== future)
    this.#elsewhere = done
    this.#done = done.filter((step) => (this.#at.get(step) ?? -1) < tick)
    this.#undone = [future]
  }

  undo(): void {
    this.#forgetFuture()
    const step = this.#done.at(-1)
    if (!step || !this.#carryOut(step, 'undo')) return
    this.#done = this.#done.slice(0, -1)
    if (step === future) [this.#done, this.#elsewhere] = [this.#elsewhere, this.#done]
    this.#undone = [...this.#undone, step]
    if (isJoined(step)) this.undo()
  }

  redo(): void {
    this.#forgetFuture()
    const step = this.#undone.at(-1)
    if (!step || !this.#carryOut(step, 'redo')) return
    this.#undone = this.#undone.slice(0, -1)
    if (step === future) [this.#done, this.#elsewhere] = [this.#elsewhere, this.#done]
    this.#done = [...this.#done, step]
    const next = this.#undone.at(-1)
    if (next && isJoined(next)) this.redo()
  }

  #forgetFuture(): void {
    if (this.#hands.hasFuture()) return
    this.#done = this.#done.filter(this.#stands)
    this.#undone = this.#undone.filter(this.#stands)
    this.#elsewhere = []
  }

  #carryOut(step: Step, direction: 'undo' | 'redo'): boolean {
    if (step.kind === 'blocks') return this.#hands.blocks(direction, step.program)
    if (step.kind === 'future') {
      this.#hands.future()
      return true
    }
    const back = direction === 'undo'
    const value = back ? step.before : step.after
    if (step.kind === 'place') this.#hands.place(step.id, value as Pose, back ? step.start : undefined)
    else if (step.kind === 'robots') this.#hands.robots(value as Document, back ? step.stood : undefined)
    else if (step.kind === 'scene') this.#hands.scene(value as Scene, back ? step.stood : undefined)
    else if (step.kind === 'config') this.#hands.config(step.id, value as RobotConfig)
    else this.#hands.brain(step.id, value as Brain)
    return true
  }
}

const isJoined = (step: Step) => step.kind === 'config' && step.joined === true
