import { SvelteMap } from 'svelte/reactivity'
import { loadCard, type LoadedCard } from '#content/cards.ts'

/** Cards that somebody works on, as far as they have come. */
class Cards {
  readonly #found = new SvelteMap<string, LoadedCard>()
  readonly #asked = new Set<string>()

  /** A card; null for now where it has to be fetched, or where there is none. */
  of(id: string): LoadedCard | null {
    if (!this.#asked.has(id)) {
      this.#asked.add(id)
      void loadCard(id).then(
        (card) => card && this.#found.set(id, card),
        () => this.#asked.delete(id),
      )
    }
    return this.#found.get(id) ?? null
  }
}

export const cards = new Cards()
