import { nearer } from './nearer.ts'

/** Of a list with more than this, a few come and go a frame. */
const many = 60
/** A list that follows another one: at once where it is short, else a few items a frame, so that no frame waits for all. */
export class Gradual<T> {
  #list = $state.raw<readonly T[]>([])
  #wanted: readonly T[] = []
  #frame = 0
  readonly #keyOf: (one: T) => number

  constructor(keyOf: (one: T) => number) {
    this.#keyOf = keyOf
  }

  get list(): readonly T[] {
    return this.#list
  }

  follow(wanted: readonly T[]): void {
    this.#wanted = wanted
    if (wanted.length <= many) {
      this.stop()
      this.#list = wanted
    } else this.#step()
  }

  stop(): void {
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
