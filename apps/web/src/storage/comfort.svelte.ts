import { readSetting, writeSetting } from './settings.ts'

const names = ['projector', 'quiet', 'letters', 'aloud'] as const

/**
 * `projector`: larger words and stronger lines for the wall · `quiet`: no mascots in the work area · `letters`: letters
 * that are hard to mix up · `aloud`: texts can be read aloud.
 */
type Wish = (typeof names)[number]

type Wishes = { readonly [wish in Wish]?: unknown }

/** How the screen meets the one before it, kept on this device. The page's root carries every wish as `data-<wish>`. */
class Comfort {
  #wishes = $state.raw<Wishes>(readSetting<Wishes | null>('comfort', null) ?? {})

  constructor() {
    this.#show()
  }

  has(wish: Wish): boolean {
    return this.#wishes[wish] === true
  }

  set(wish: Wish, on: boolean): void {
    this.#wishes = Object.fromEntries(names.map((name) => [name, name === wish ? on : this.has(name)]))
    writeSetting('comfort', this.#wishes)
    this.#show()
  }

  // Set before anything is drawn, so that nothing flashes.
  #show(): void {
    const root = globalThis.document?.documentElement
    for (const name of names) root?.toggleAttribute(`data-${name}`, this.has(name))
  }
}

export const comfort = new Comfort()
