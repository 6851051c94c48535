import type { Back } from '@botgarten/programs/together'
import type { OwnSteps } from '#lab/undo.svelte.ts'

type Step = readonly Back[]

interface Host {
  /** What is under way becomes a step of its own first. */
  settle(): void
  /** @returns what does it again; null: not while a hand holds a block */
  takeBack(step: Step): Step | null
}

/** What this child has done of a common program, to take back and do again. */
export class StepsOfOne implements OwnSteps {
  readonly #host: Host
  #done = $state.raw<readonly Step[]>([])
  #undone = $state.raw<readonly Step[]>([])

  constructor(host: Host) {
    this.#host = host
  }

  get canUndo() {
    return this.#done.length > 0
  }
  get canRedo() {
    return this.#undone.length > 0
  }

  did(step: Step): void {
    this.#done = [...this.#done, step]
    this.#undone = []
  }

  undo(): void {
    this.#host.settle()
    const back = this.#back(this.#done.at(-1))
    if (!back) return
    this.#done = this.#done.slice(0, -1)
    this.#undone = [...this.#undone, ...back]
  }

  redo(): void {
    this.#host.settle()
    const back = this.#back(this.#undone.at(-1))
    if (!back) return
    this.#undone = this.#undone.slice(0, -1)
    this.#done = [...this.#done, ...back]
  }

  /** What was taken back, where anything was; null: it was not. */
  #back(step: Step | undefined): readonly Step[] | null {
    const back = step && this.#host.takeBack(step)
    return back ? [back].filter(({ length }) => length > 0) : null
  }
}
