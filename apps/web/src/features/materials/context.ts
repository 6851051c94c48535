import { getContext, setContext } from 'svelte'

const waitingKey = Symbol('waiting')
/** What is brought may itself load something: so long, in milliseconds, nothing new may have been asked for. */
const calm = 80

/** What a part of a page still waits for: pictures that are drawn from files that come a moment later. */
export class Waiting {
  #count = 0
  #places = new Set<Element>()

  /** Notes that something is on its way. */
  async for<Thing>(thing: Promise<Thing>): Promise<Thing> {
    this.#count += 1
    this.#tell(true)
    try {
      return await thing
    } finally {
      this.#count -= 1
      setTimeout(() => this.#tell(this.#count > 0), calm)
    }
  }

  /** The element that says by `aria-busy` whether everything is there. */
  mark = (place: Element): (() => void) => {
    this.#places.add(place)
    place.setAttribute('aria-busy', 'true')
    setTimeout(() => this.#tell(this.#count > 0), calm)
    return () => this.#places.delete(place)
  }

  /** An attribute that is set is news to who observes it, even where it stays the same. */
  #tell(busy: boolean): void {
    for (const place of this.#places)
      if (place.getAttribute('aria-busy') !== String(busy)) place.setAttribute('aria-busy', String(busy))
  }
}

export const giveWaiting = (): Waiting => setContext(waitingKey, new Waiting())
export const takeWaiting = (): Waiting => getContext<Waiting | undefined>(waitingKey) ?? new Waiting()

const shownKey = Symbol('shown')

/** What stands in here is shown to a class: it may be worked with, and is not a picture of itself. */
export const giveShown = (): void => void setContext(shownKey, true)
export const isShown = (): boolean => getContext<true | undefined>(shownKey) ?? false
