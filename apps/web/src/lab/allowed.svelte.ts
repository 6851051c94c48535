/** Which cards and blocks a teacher leaves open today. `cards`: ids; null: all. `level`: null: as the child likes. */
interface Today {
  readonly cards: readonly string[] | null
  readonly level: 'plain' | 'all' | null
  /** Is the free lab, too, open only where it is among the cards? */
  readonly strict?: boolean
  /** Is there a gallery of the class? May classmates be asked? Not given: no. */
  readonly gallery?: boolean
  readonly asking?: boolean
  /** May two work on one program? */
  readonly together?: boolean
}

/** What may be opened today. Without a class or a study that is everything but what only a class has; they set it. */
class Allowed {
  #today = $state.raw<Today>({ cards: null, level: null })
  #galleryNews = $state(0)

  set(today: Today): void {
    // What is drawn from it is looked at again only where it has changed.
    if (JSON.stringify(today) !== JSON.stringify(this.#today)) this.#today = today
  }
  /** @param place a card by its id, or `free` */
  isOpen(place: string): boolean {
    const { cards, strict } = this.#today
    return (place === 'free' && !strict) || (cards?.includes(place) ?? true)
  }
  get gallery() {
    return this.#today.gallery ?? false
  }
  /** Grows when something in the gallery of the class is another. */
  get galleryNews() {
    return this.#galleryNews
  }
  seeGallery(): void {
    this.#galleryNews++
  }
  get asking() {
    return this.#today.asking ?? false
  }
  get together() {
    return this.#today.together ?? false
  }
  get level() {
    return this.#today.level
  }
}

export const allowed = new Allowed()
