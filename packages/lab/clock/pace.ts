import { TICKS_PER_SECOND } from '@botgarten/simulation'

/** At most this many ticks a frame at speed 1: a page that was away does not catch up in one leap. */
const MOST_TICKS = 6

/** Turns passing real time into whole ticks; what is left over waits for the next frame. */
export class Pace {
  #left = 0

  /**
   * @param milliseconds real time since the last frame
   * @param speed simulated seconds a real second; Infinity: as many ticks as there is time for, and Infinity is returned
   */
  ticksFor(milliseconds: number, speed = 1): number {
    if (speed === Infinity) return Infinity
    this.#left += (milliseconds / 1000) * speed * TICKS_PER_SECOND
    // A frame that comes a hair early still gets its tick: displays at 60 Hz then move in every frame.
    const ticks = Math.floor(this.#left + 0.05)
    this.#left -= ticks
    const most = MOST_TICKS * Math.max(1, speed)
    if (ticks <= most) return ticks
    this.#left = 0
    return most
  }
}
