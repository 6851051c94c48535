/** One change by hand: `start` before it (for undo), `move` as often as it changes, `end` with the last value. */
export type Phase = 'start' | 'move' | 'end'

// What is shown may lag a few frames behind what was asked for.
const lag = 250

/** Changing something by keys, from the first press until the key is let go. */
export class Nudge<T> {
  #pushing = false
  #last: { readonly shown: T; readonly wanted: T; readonly at: number } | null = null
  #emit: (value: T, phase: Phase) => void

  constructor(emit: (value: T, phase: Phase) => void) {
    this.#emit = emit
  }

  /**
   * `shown` is where it stands now, `change` where a press brings it (null: that key does nothing), `now` in ms. While
   * the screen still shows the old value, presses go on from the one asked for last.
   */
  push(shown: T, change: (from: T) => T | null, now: number): boolean {
    const last = this.#last
    const lags = last !== null && last.shown === shown && now - last.at < lag
    const from = last && (this.#pushing || lags) ? last.wanted : shown
    const wanted = change(from)
    if (wanted === null) return false
    if (!this.#pushing) this.#emit(from, 'start')
    this.#pushing = true
    this.#last = { shown, wanted, at: now }
    this.#emit(wanted, 'move')
    return true
  }

  letGo(): void {
    if (this.#pushing && this.#last) this.#emit(this.#last.wanted, 'end')
    this.#pushing = false
  }
}
