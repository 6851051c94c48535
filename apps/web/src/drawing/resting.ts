/** Frames without a movement after which a thing rests. */
const still = 30

/** Separates what moves from what rests, so that what rests is painted as one picture. */
export class Resting<T> {
  #before: ReadonlySet<T> = new Set()
  /** Frames that are left until it rests. */
  readonly #moving = new Map<T, number>()
  #resting: readonly T[] = []

  /** @param all of one frame; what has not moved is the same object as before */
  split(all: readonly T[]): { readonly resting: readonly T[]; readonly moving: readonly T[] } {
    const isFirst = this.#before.size === 0
    const moving = new Set(all.filter((one) => this.#moves(one, isFirst)))
    this.#before = new Set(all)
    this.#resting = steady(
      this.#resting,
      all.filter((one) => !moving.has(one)),
    )
    for (const one of this.#moving.keys()) if (!this.#before.has(one)) this.#moving.delete(one)
    return { resting: this.#resting, moving: [...moving] }
  }

  #moves(one: T, isFirst: boolean): boolean {
    const left = this.#before.has(one) || isFirst ? (this.#moving.get(one) ?? 0) - 1 : still
    if (left > 0) this.#moving.set(one, left)
    else this.#moving.delete(one)
    return left > 0
  }
}

const steady = <T>(before: readonly T[], now: readonly T[]): readonly T[] =>
  before.length === now.length && before.every((one, i) => one === now[i]) ? before : now
