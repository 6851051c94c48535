import type { RobotConfig } from '@botgarten/simulation'
import { keepRobots, readRobots, withKept, withoutKept } from './kept.ts'

/** The robots that are saved on this device, as a list that is changed by hand. */
export class SavedRobots {
  #robots = $state.raw(readRobots())
  #error = $state<'full' | 'refused' | null>(null)
  #removed = $state.raw<{ readonly name: string; readonly config: RobotConfig } | null>(null)

  get robots() {
    return this.#robots
  }

  /** Why the last robot was not saved: there are too many, or the device refuses. */
  get error() {
    return this.#error
  }

  /** The one that was removed last, while it can be restored. */
  get removed() {
    return this.#removed
  }

  /** Returns whether the robot is saved now; `error` says why not. */
  save(name: string, config: RobotConfig): boolean {
    const next = withKept(this.#robots, name, config)
    if (next) this.#robots = keepRobots(next)
    this.#removed = null
    this.#error = !next ? 'full' : Object.hasOwn(this.#robots, name) ? null : 'refused'
    return this.#error === null
  }

  remove(name: string): void {
    const config = this.#robots[name]
    if (!config) return
    this.#robots = keepRobots(withoutKept(this.#robots, name))
    this.#removed = { name, config }
  }

  restore(): void {
    if (this.#removed) this.save(this.#removed.name, this.#removed.config)
  }
}
