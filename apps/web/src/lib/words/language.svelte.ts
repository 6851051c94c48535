import { isLocale, locales, overwriteGetLocale, type Locale } from './generated/runtime.js'

const key = 'botgarten.language'

/** What the browser asks for first, else English. */
export function preferred(wishes: readonly string[]): Locale {
  for (const wish of wishes) {
    const language = wish.toLowerCase().split('-')[0]
    if (isLocale(language)) return language
  }
  return 'en'
}

// A browser may refuse storage altogether: even reading the property throws then.
function remembered(): Locale | null {
  try {
    const kept = localStorage.getItem(key)
    return isLocale(kept) ? kept : null
  } catch {
    return null
  }
}

function remember(locale: Locale): void {
  try {
    localStorage.setItem(key, locale)
  } catch {
    // The switch holds until the page is left.
  }
}

/** The language of all words on the screen. Changing it words the page anew in place. */
class Language {
  #locale = $state<Locale>(remembered() ?? preferred(globalThis.navigator?.languages ?? []))
  readonly all = locales

  constructor() {
    overwriteGetLocale(() => this.#locale)
  }

  get locale(): Locale {
    return this.#locale
  }

  speak(locale: Locale): void {
    this.#locale = locale
    remember(locale)
  }
}

export const language = new Language()
