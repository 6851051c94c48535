import type { LabSession } from './session.svelte.ts'

/** Speeds to choose from, in simulated seconds a real second. Infinity: as fast as it can. */
export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16, Infinity] as const

/** The bar of time below the world: whether it is open, which moment is shown, how fast time passes. */
export class TimeMachine {
  #session: LabSession
  /** Does the child want to see the bar? */
  #wanted = $state(false)

  constructor(session: LabSession) {
    this.#session = session
  }

  get past() {
    return this.#session.lab.facts.past
  }
  /** Nothing has run yet. */
  get empty() {
    return this.#session.lab.facts.empty
  }
  get open() {
    return this.#wanted && !this.empty
  }
  get running() {
    return this.#session.lab.facts.phase === 'running'
  }
  get view() {
    return this.#session.lab.view
  }
  get speed() {
    return this.#session.lab.speed
  }
  set speed(speed: number) {
    this.#session.lab.speed = speed
  }

  /** Shows the bar, or puts it away and comes back to the present. */
  toggle(): void {
    this.#wanted = !this.#wanted
    if (!this.#wanted) this.now()
  }

  lookAt(tick: number): void {
    this.#session.lab.lookAt(tick)
  }

  goTo(tick: number): void {
    this.#session.lab.goTo(tick)
  }

  /** One tick back or forth. */
  step(by: 1 | -1): void {
    this.#session.lab.goTo(this.view.tick + by)
  }

  goOn(): void {
    this.#session.resume()
  }

  now(): void {
    this.#session.lab.goTo(Infinity)
  }
}
