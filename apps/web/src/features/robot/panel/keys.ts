import type { RobotKey } from '@botgarten/simulation'

/** A quick tap still lasts this long, in milliseconds, so that the program sees it. */
const SHORTEST = 120

/** Fingers on the keys of the robot's panel. */
export class Fingers {
  readonly #press: (key: RobotKey, down: boolean) => void
  readonly #since = new Map<RobotKey, number>()

  constructor(press: (key: RobotKey, down: boolean) => void) {
    this.#press = press
  }

  down(key: RobotKey): void {
    if (!this.#since.has(key)) this.#press(key, true)
    this.#since.set(key, performance.now())
  }

  up(key: RobotKey): void {
    const since = this.#since.get(key)
    if (since === undefined) return
    const left = since + SHORTEST - performance.now()
    if (left <= 0) this.#letGo(key)
    else setTimeout(() => this.#since.get(key) === since && this.#letGo(key), left)
  }

  /** The panel goes away: nothing stays pressed. */
  upAll(): void {
    for (const key of this.#since.keys()) this.#letGo(key)
  }

  #letGo(key: RobotKey): void {
    this.#since.delete(key)
    this.#press(key, false)
  }
}
