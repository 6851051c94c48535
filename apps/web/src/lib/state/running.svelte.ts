import {
  createLab,
  Pace,
  type Check,
  type Document,
  type DriveKey,
  type Lab,
  type StepKind,
  type View,
} from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Program } from '@botgarten/programs'
import type { Floor, Pose } from '@botgarten/simulation'

/** A lab for the screen: one view a frame, and the verbs of a child's hand. */
export class RunningLab {
  #lab: Lab = createLab()
  #pace = new Pace()
  #view = $state.raw<View>() as View
  #document = $state.raw<Document>() as Document
  #frame = 0
  #before = 0

  constructor(document: Document, floor: Floor, checks: readonly Check[]) {
    this.#lab.load(document, floor, { seed: 1, checks })
    this.#show()
  }

  get view() {
    return this.#view
  }
  /** Programs, brains with the weights of now, world with the start poses. */
  get document() {
    return this.#document
  }

  /** Lets time run with the screen's frames. Returns how to stop. */
  run(): () => void {
    const frame = (now: number) => {
      this.#frame = requestAnimationFrame(frame)
      const ticks = this.#pace.ticksFor(this.#before ? now - this.#before : 0)
      this.#before = now
      if (this.#lab.advance(ticks)) this.#show()
    }
    this.#frame = requestAnimationFrame(frame)
    return () => cancelAnimationFrame(this.#frame)
  }

  #show(): void {
    this.#view = this.#lab.view()
    this.#document = this.#lab.document()
  }

  start = () => this.#then(() => this.#lab.start())
  stop = () => this.#then(() => this.#lab.stop())
  pause = () => this.#then(() => this.#lab.pause())
  resume = () => this.#then(() => this.#lab.resume())
  reset = () => this.#then(() => this.#lab.reset())
  step = (kind: StepKind) => this.#then(() => this.#lab.step(kind))
  press = (key: DriveKey, down: boolean) => this.#lab.press(key, down)
  place = (id: string, pose: Pose) => this.#then(() => this.#lab.place(id, pose))
  setWeight = (brain: string, from: string, to: string, weight: number) =>
    this.#then(() => this.#lab.setWeight(brain, from, to, weight))
  setBrain = (id: string, brain: Brain) => this.#then(() => this.#lab.setBrain(id, brain))
  edit = (programs: { readonly [id: string]: Program }) => this.#then(() => this.#lab.edit(programs))

  #then<Result>(verb: () => Result): Result {
    const result = verb()
    this.#show()
    return result
  }
}
