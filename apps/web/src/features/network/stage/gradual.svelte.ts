/** Of a list with more than this, a few come and go a frame. */
const many = 60
/** In one frame: to make what answers to a hand takes a slow laptop a third of a millisecond each. */
const atATime = 6

/** The next of the lists on the way from what is there to what is wanted: a few more of these, a few less of those. */
export function nearer<T>(
  there: readonly T[],
  wanted: readonly T[],
  keyOf: (one: T) => number,
): readonly T[] {
  const next = new Map(wanted.map((one) => [keyOf(one), one]))
  const kept = new Set(there.map(keyOf))
  const gone = there.filter((one) => !next.has(keyOf(one)))
  const leaving = new Set(gone.slice(0, atATime).map(keyOf))
  const coming = new Set([...next.keys()].filter((key) => !kept.has(key)).slice(0, atATime))
  const all = wanted.filter((one) => kept.has(keyOf(one)) || coming.has(keyOf(one)))
  return [...all, ...gone.filter((one) => !leaving.has(keyOf(one)))]
}

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
