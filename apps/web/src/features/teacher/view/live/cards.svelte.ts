import { loadCard, type LoadedCard } from '#content/cards.ts'

/** Cards that somebody works on, as far as they have come. */
class Cards {
  #found = $state.raw<{ readonly [id: string]: LoadedCard }>({})
  readonly #asked = new Set<string>()

  /** A card; null for now where it has to be fetched, or where there is none. */
  of(id: string): LoadedCard | null {
    if (!this.#asked.has(id)) {
      this.#asked.add(id)
      void loadCard(id).then(
        (card) => card && (this.#found = { ...this.#found, [id]: card }),
        () => this.#asked.delete(id),
      )
    }
    return Object.hasOwn(this.#found, id) ? this.#found[id]! : null
  }
}

export const cards = new Cards()
