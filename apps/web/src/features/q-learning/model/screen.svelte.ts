import type { Course } from '@botgarten/learning/q-learning'
import { shownOf, type Shown } from './shown.ts'

/** Milliseconds that a move has to be shown so that it can be read. */
const CALM = 250

/**
 * State of a course as the screen shows it. At high speed the map is updated in one frame, numbers and words in the next:
 * each frame has half of the work.
 */
export class Screen {
  #drawn = $state.raw<Shown | null>(null)
  #told = $state.raw<Shown | null>(null)
  #isFleeting = $state(false)
  #waiting = 0
  #calm = 0

  /** What the map shows. */
  get drawn() {
    return this.#drawn
  }
  /** What numbers, tables and words show. */
  get told() {
    return this.#told
  }
  /** Do words wait for the next frame? */
  get isBusy() {
    return this.#waiting !== 0
  }

  /** Do moves follow each other too fast to be read? */
  get isFleeting() {
    return this.#isFleeting
  }

  clear(): void {
    this.#drawn = this.#told = null
  }

  show(course: Course): void {
    this.#drawn = this.#told = shownOf(course)
    this.#rest()
  }

  showInTurns(course: Course): void {
    this.#isFleeting = true
    clearTimeout(this.#calm)
    this.#calm = window.setTimeout(this.#rest, CALM)
    this.#drawn = shownOf(course)
    if (this.#waiting === 0) this.#waiting = requestAnimationFrame(this.#tell)
  }

  #rest = (): void => {
    clearTimeout(this.#calm)
    this.#isFleeting = false
  }

  #tell = (): void => {
    this.#waiting = 0
    this.#told = this.#drawn
  }
}
