/** So many are remembered before all are forgotten. */
const most = 500

/** What was made once for a key, so that it is the same object the next time. */
export class Remembered<T> {
  readonly #known = new Map<string, T>()

  of(key: string, make: () => T): T {
    const known = this.#known.get(key)
    if (known !== undefined) return known
    if (this.#known.size >= most) this.#known.clear()
    const made = make()
    this.#known.set(key, made)
    return made
  }
}
