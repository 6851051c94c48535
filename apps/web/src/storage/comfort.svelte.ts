import { readSetting, writeSetting } from './settings.ts'

const names = ['projector', 'quiet', 'letters', 'aloud'] as const

/**
 * `projector`: larger words and stronger lines for the wall · `quiet`: no mascots in the work area · `letters`: letters
 * that are hard to mix up · `aloud`: texts can be read aloud.
 */
type Option = (typeof names)[number]

type Options = { readonly [option in Option]?: unknown }

/** How the screen meets the one before it, kept on this device. The page's root carries every option as `data-<option>`. */
class Comfort {
  #options = $state.raw<Options>(readSetting<Options | null>('comfort', null) ?? {})

  constructor() {
    this.#show()
  }

  has(option: Option): boolean {
    return this.#options[option] === true
  }

  set(option: Option, on: boolean): void {
    this.#options = Object.fromEntries(names.map((name) => [name, name === option ? on : this.has(name)]))
    writeSetting('comfort', this.#options)
    this.#show()
  }

  // Set before anything is drawn, so that nothing flashes.
  #show(): void {
    const root = globalThis.document?.documentElement
    for (const name of names) root?.toggleAttribute(`data-${name}`, this.has(name))
  }
}

export const comfort = new Comfort()
