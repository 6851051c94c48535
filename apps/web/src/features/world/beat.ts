/** Milliseconds. */
const beat = 1000

/**
 * When handles go to where things are: at once where nothing runs or a hand is near, else once a second. To move one
 * costs the browser 6 ms on a slow laptop: it orders all layers of the page again.
 */
export class Beat {
  #last = -Infinity

  /** @param now in milliseconds; @param live does anything run; @param near is a hand, or the focus, on one of them */
  isDue(now: number, live: boolean, near: boolean): boolean {
    if (live && !near && now - this.#last < beat) return false
    this.#last = now
    return true
  }
}
