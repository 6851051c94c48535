import type { DriveKey } from '@botgarten/lab'
import { driveKey } from './keys.ts'

/** Arrow keys that are down. A key that is let go of anywhere is let go of here. */
export class Driver {
  #down: readonly DriveKey[] = []
  #onkey: (key: DriveKey, down: boolean) => void

  constructor(onkey: (key: DriveKey, down: boolean) => void) {
    this.#onkey = onkey
  }

  press(event: KeyboardEvent): void {
    const key = driveKey(event)
    if (!key) return
    event.preventDefault()
    if (this.#down.includes(key)) return
    this.#down = [...this.#down, key]
    this.#onkey(key, true)
  }

  letGo(event: KeyboardEvent): void {
    const key = driveKey({ key: event.key })
    if (!key || !this.#down.includes(key)) return
    this.#down = this.#down.filter((one) => one !== key)
    this.#onkey(key, false)
  }

  letGoOfAll(): void {
    for (const key of this.#down) this.#onkey(key, false)
    this.#down = []
  }
}
