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

/** The next items, each as the object it was before where it is the same. */
export function sameOnes<T>(
  before: readonly T[],
  next: readonly T[],
  keyOf: (one: T) => unknown,
  isSame: (a: T, b: T) => boolean,
): readonly T[] {
  const known = new Map(before.map((one) => [keyOf(one), one]))
  return next.map((one) => {
    const old = known.get(keyOf(one))
    return old !== undefined && isSame(old, one) ? old : one
  })
}

/** Gives back the last value for as long as the next one says the same. */
export function steady<T>(): (next: T) => T {
  let last: { readonly value: T; readonly text: string } | null = null
  return (value) => {
    const text = JSON.stringify(value)
    if (text !== last?.text) last = { value, text }
    return last.value
  }
}
