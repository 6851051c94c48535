import { nearer, renewed } from './nearer.ts'

/** Of a list with more than this, a few come and go a frame. */
export const many = 60
/** Milliseconds without another list, and without panning, after which they begin to. */
const rest = 400

/** A list that follows another one: at once where it is short, else a few items a frame, so that no frame waits for all. */
export class Gradual<T> {
  #list = $state.raw<readonly T[]>([])
  #wanted: readonly T[] = []
  #frame = 0
  #timer: ReturnType<typeof setTimeout> | undefined
  readonly #keyOf: (one: T) => number

  constructor(keyOf: (one: T) => number) {
    this.#keyOf = keyOf
  }

  get list(): readonly T[] {
    return this.#list
  }

  /** @param atOnce somebody waits for them */
  follow(wanted: readonly T[], atOnce: boolean): void {
    this.stop()
    this.#wanted = wanted
    if (wanted.length <= many) this.#list = wanted
    else if (atOnce || this.#list.length === 0) this.#step()
    else {
      this.#list = renewed(this.#list, wanted, this.#keyOf)
      this.#stepLater()
    }
  }

  /** It is panned: what is on its way waits until it rests. */
  wait(): void {
    if (!this.#timer && !this.#frame) return
    this.stop()
    this.#stepLater()
  }

  #stepLater(): void {
    this.#timer = setTimeout(() => {
      this.#timer = undefined
      this.#step()
    }, rest)
  }

  stop(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
  }

  #step(): void {
    this.#list = nearer(this.#list, this.#wanted, this.#keyOf)
    const arrived =
      this.#list.length === this.#wanted.length && this.#list.every((one, i) => one === this.#wanted[i])
    if (arrived || this.#frame) return
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0
      this.#step()
    })
  }
}
