/** Milliseconds of a move. */
const MOVE = 600
/** Time that one frame can be late for: a page that slept does not catch up. */
const LATEST = 250

/** Plays the moves that Bo makes, one after the other. */
export class Playback {
  readonly #count: () => number
  /** Moves begun: the whole part of them is over. */
  #at = $state(0)
  #playing = $state(false)
  /** It plays up to here. */
  #until = 0
  #frame = 0
  #before = 0

  constructor(count: () => number) {
    this.#count = count
  }

  get playing() {
    return this.#playing
  }
  /** The move that is shown, from 0. */
  get index() {
    return Math.max(0, Math.min(Math.ceil(this.#at) - 1, this.#count() - 1))
  }
  /** 0..1 of it. */
  get progress() {
    return this.#at === 0 ? 0 : this.#at - this.index
  }
  /** Moves that are over. */
  get made() {
    return Math.floor(this.#at)
  }
  get over() {
    return this.#count() > 0 && this.#at >= this.#count()
  }

  restart(): void {
    this.#at = 0
    this.play()
  }

  play(): void {
    this.#start(this.#count())
  }

  /** One move, from the last one that is whole. */
  step(): void {
    if (this.over) this.#at = 0
    this.#start(Math.floor(this.#at) + 1)
  }

  /** Ends the walk: nothing is shown of it any more. */
  stop(): void {
    this.pause()
    this.#at = 0
  }

  pause(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#playing = false
  }

  #start(until: number): void {
    this.#until = Math.min(until, this.#count())
    this.#before = performance.now()
    this.#playing = true
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#tick)
  }

  #tick = (now: number): void => {
    const passed = Math.min(LATEST, Math.max(0, now - this.#before))
    this.#before = now
    this.#at = Math.min(this.#until, this.#at + passed / MOVE)
    if (this.#at >= this.#until) return this.pause()
    this.#frame = requestAnimationFrame(this.#tick)
  }
}
