/** Duration of a race at ×1, in ms. */
const WHOLE = 16_000

/** The shown moment of a race, and its playback. */
export class Playback {
  /** Index of a point of the curves. */
  #at = $state(0)
  #count = $state(0)
  #playing = $state(false)
  /** 1, 2, 3; Infinity: the end at once. */
  speed = $state(Infinity)
  #frame = 0

  get at() {
    return this.#at
  }
  get count() {
    return this.#count
  }
  get playing() {
    return this.#playing
  }
  get atEnd() {
    return this.#at >= this.#count - 1
  }

  /** Starts the playback of a race with `count` points; shows its end at once in turbo and where motion is reduced. */
  begin(count: number): void {
    this.#count = count
    const still = this.speed === Infinity || matchMedia('(prefers-reduced-motion: reduce)').matches
    this.goTo(still ? count - 1 : 0)
    if (!still) this.play()
  }

  goTo(at: number): void {
    this.stop()
    this.#at = Math.max(0, Math.min(at, this.#count - 1))
  }

  play(): void {
    if (this.atEnd) this.#at = 0
    if (this.speed === Infinity) return this.goTo(this.#count - 1)
    this.#playing = true
    const [from, started] = [this.#at, performance.now()]
    const next = (now: number) => {
      // The first frame may have begun before it was asked for.
      const passed = (Math.max(0, now - started) / WHOLE) * this.speed * this.#count
      this.#at = Math.min(this.#count - 1, from + Math.floor(passed))
      if (this.atEnd) this.stop()
      else this.#frame = requestAnimationFrame(next)
    }
    this.#frame = requestAnimationFrame(next)
  }

  stop(): void {
    cancelAnimationFrame(this.#frame)
    this.#playing = false
  }
}
