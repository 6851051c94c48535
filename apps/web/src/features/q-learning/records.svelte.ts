import type { Episode } from '@botgarten/learning/q-learning'
import type { LearnedRun } from '@botgarten/programs'

const MOST_RUNS = 200
/** So many runs are drawn over each other. */
const OVERLAID = 5

/** What earlier runs have left: their rows and their curves. */
export class Records {
  #runs = $state.raw<readonly LearnedRun[]>([])
  #curves = $state.raw<readonly (readonly Episode[])[]>([])

  constructor(runs: readonly LearnedRun[]) {
    this.#runs = runs
  }

  /** Rows of the table of experiments, the oldest first. */
  get runs() {
    return this.#runs
  }
  /** Episodes of the last runs, the newest first. */
  get curves() {
    return this.#curves
  }

  note(run: LearnedRun, episodes: readonly Episode[]): void {
    this.#runs = [...this.#runs, run].slice(-MOST_RUNS)
    this.draw(episodes)
  }

  draw(episodes: readonly Episode[]): void {
    this.#curves = [episodes, ...this.#curves.filter((one) => one !== episodes)].slice(0, OVERLAID)
  }

  forget(): void {
    this.#runs = []
  }
}
