import { weightsOf, withWeights, type PracticeNote, type Weights } from '@botgarten/learning/neural-network'
import type { Assignment } from './assignment.svelte.ts'

/** The knobs of the network on the screen, in the hands of practice. */
export class Knobs {
  readonly #assignment: Assignment
  /** Weights before the step that is under way, for who undoes it. */
  #before: Weights | null = null
  /** The weights that practice has put on the knobs last. */
  #written = $state.raw<Weights | null>(null)
  /** What the project said of practice when it was looked at last. */
  #noteTaken: PracticeNote | undefined
  isOwn = false

  constructor(assignment: Assignment) {
    this.#assignment = assignment
  }

  get #set() {
    return this.#assignment.session.robot.brain
  }
  get weights(): Weights {
    const { brain } = this.#assignment
    return brain ? weightsOf(brain, this.#set) : {}
  }

  /** Do they stand as practice has left them? Else a hand has turned one since. */
  readonly stands = $derived.by(() => this.#written !== null && this.#written === this.weights)

  /** Does the project say something else of practice than when it was looked at last? */
  get isOther(): boolean {
    return this.#assignment.note !== this.#noteTaken
  }

  /** Here a step begins. */
  hold(): void {
    this.#before ??= this.weights
  }

  /** These weights are practice's own. */
  take(): void {
    this.#written = this.weights
  }

  forget(): void {
    this.#before = null
    this.#written = null
    this.#noteTaken = this.#assignment.note
  }

  write(weights: Weights): void {
    this.hold()
    this.#written = weights
    this.as(() => this.#put(weights))
  }

  #put(weights: Weights): void {
    const { session, net, brain } = this.#assignment
    if (net && brain)
      session.apply({ kind: 'brain', id: net.id, after: withWeights(brain, weights, this.#set) }, 'silent')
  }

  /** Makes one step of all that was written since it was held. */
  commit(note: () => PracticeNote): void {
    const { session, net } = this.#assignment
    const [before, weights] = [this.#before, this.weights]
    this.#before = null
    if (!net || !before || before === weights) return
    this.as(() => {
      this.#put(before)
      session.examples.practised(net.id, weights, note())
    })
    this.take()
  }

  /** What happens now is practice's own doing. */
  as(act: () => void): void {
    this.isOwn = true
    try {
      act()
    } finally {
      this.isOwn = false
      this.#noteTaken = this.#assignment.note
    }
  }
}
