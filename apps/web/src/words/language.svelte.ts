import { languages as all, names } from 'content:words'
import type { Locale } from './generated/files.ts'

export type { Locale }

const key = 'botgarten.language'
const isLocale = (name: unknown): name is Locale => all.includes(name as Locale)

/** What the browser asks for first, else English. */
export function preferred(requested: readonly string[]): Locale {
  for (const one of requested) {
    const language = one.toLowerCase().split('-')[0]
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

/** Brings what a language needs before it can be spoken. */
type Bringing = (locale: Locale) => Promise<unknown>

/** The language of all words on the screen. Changing it words the page again in place. */
class Language {
  #locale = $state<Locale>(remembered() ?? preferred(globalThis.navigator?.languages ?? []))
  #requested: Locale | null = null
  readonly #needs = new Set<Bringing>()
  readonly all = all
  /** What each is called in itself. */
  readonly names = names

  get locale(): Locale {
    return this.#locale
  }

  /** From now on a language is spoken once this has been brought for it. */
  needs(bringing: Bringing): void {
    this.#needs.add(bringing)
  }

  /** Speaks another language; where its words do not come, the page goes on in the one it has. */
  async speak(locale: Locale): Promise<void> {
    if (await this.speakForNow(locale)) remember(locale)
  }

  /** As `speak`, and a later visit knows nothing of it. @returns false where the words did not come, or another was asked for since */
  async speakForNow(locale: Locale): Promise<boolean> {
    this.#requested = locale
    try {
      await Promise.all([...this.#needs].map((load) => load(locale)))
    } catch (cause) {
      console.warn('The words of a language did not come.', cause)
      return false
    }
    if (this.#requested !== locale) return false
    this.#locale = locale
    return true
  }
}

export const language = new Language()
