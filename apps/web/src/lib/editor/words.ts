import * as messages from '#lib/words/generated/messages/_index.js'

export type Locale = 'en' | 'de'

/** Says a message key; unknown keys come back as they are, so that a missing word is seen, not a crash. */
export type Words = (key: string, facts?: { readonly [name: string]: string | number }) => string

type Message = (facts: object, options: { locale: Locale }) => string

export function wordsIn(locale: Locale): Words {
  const all = messages as unknown as { readonly [key: string]: Message | undefined }
  return (key, facts = {}) => all[key]?.(facts, { locale }) ?? key
}
