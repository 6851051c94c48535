import { stepSettings } from '@botgarten/learning/neural-network/examples'
import type { Assignment } from './assignment.svelte.ts'
import { overSeeds, overSizes, type Line } from './studies.ts'

/** Milliseconds of a frame that comparing takes. */
const budget = 6

const studies = { seeds: overSeeds, sizes: overSizes }
export type Study = keyof typeof studies

/** What came of several practices, beside each other. */
export interface Compared {
  readonly study: Study
  readonly lines: readonly Line[]
}

/** Practises several times what is chosen, and changes no knob. */
export class Comparing {
  readonly #assignment: Assignment
  #result = $state.raw<Compared | null>(null)
  #going = $state<Study | null>(null)
  #frame = 0

  constructor(assignment: Assignment) {
    this.#assignment = assignment
  }

  get result() {
    return this.#result
  }
  get going() {
    return this.#going
  }

  go(study: Study): void {
    const { knobs, choice, obstacle } = this.#assignment
    const exercise = this.#assignment.exercise(knobs.weights)
    if (!exercise || obstacle || this.#going) return
    this.#going = study
    const work = studies[study](exercise, stepSettings(choice))
    const pass = () => {
      const end = performance.now() + budget
      do {
        const { done, value } = work.next()
        if (done) return this.#done(study, value)
      } while (performance.now() < end)
      this.#frame = requestAnimationFrame(pass)
    }
    this.#frame = requestAnimationFrame(pass)
  }

  #done(study: Study, lines: readonly Line[]): void {
    this.#going = null
    this.#result = { study, lines }
  }

  close(): void {
    cancelAnimationFrame(this.#frame)
    this.#going = null
  }
}
