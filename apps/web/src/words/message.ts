import { files } from 'content:words'
import { fill, type Facts, type Message } from '@botgarten/messages'
import type { WordsFile } from './generated/files.ts'
import type { Messages } from './generated/messages.ts'
import { language, type Locale } from './language.svelte.ts'

/** Says a message key; unknown keys come back as they are, so that a missing word is seen, not a crash. */
export type Words = (key: string, facts?: Facts) => string

/** Every message that has been fetched, by language. */
const messages: { readonly [locale in Locale]?: Map<string, Message> } = Object.fromEntries(
  Object.keys(files).map((locale) => [locale, new Map()]),
)
const fetching = new Map<WordsFile, (locale: Locale) => Promise<void>>()

/** Fetches a file's messages; what a language lacks is in them in the language that it falls back to. */
function fetcherOf(file: WordsFile): (locale: Locale) => Promise<void> {
  const fetched = new Set<Locale>()
  return async (locale) => {
    if (fetched.has(locale)) return
    const { default: table } = await files[locale][file]()
    for (const [key, message] of Object.entries(table)) messages[locale]?.set(key, message)
    fetched.add(locale)
  }
}

function fetcherFor(file: WordsFile): (locale: Locale) => Promise<void> {
  const fetch = fetching.get(file) ?? fetcherOf(file)
  fetching.set(file, fetch)
  return fetch
}

/** Fetches files of `content/words/<language>`, in the language of now and in each that will be spoken: before one of their messages is said. */
export async function fetchWords(...named: readonly WordsFile[]): Promise<void> {
  await Promise.all(
    named.map((file) => {
      const fetch = fetcherFor(file)
      language.needs(fetch)
      return fetch(language.locale)
    }),
  )
}

/** Fetches a file's messages in every language: for a document that says all in each of them. */
export const fetchInAll = (file: WordsFile): Promise<unknown> =>
  Promise.all(language.all.map((locale) => fetcherFor(file)(locale)))

/**
 * A lazy part of a page, once the messages that it says have come too.
 * @param failed takes back the request where it cannot be loaded, so that the next press asks again
 */
export async function withWords<Part>(
  part: Promise<Part>,
  named: readonly WordsFile[],
  failed?: () => void,
): Promise<Part> {
  try {
    return (await Promise.all([part, fetchWords(...named)]))[0]
  } catch (cause) {
    failed?.()
    throw cause
  }
}

/** Is there a message of this key? */
export const hasMessage = (key: string): boolean => messages[language.locale]?.has(key) ?? false

/** Words of a language that has been fetched. */
export const wordsIn =
  (locale: Locale): Words =>
  (key, facts = {}) => {
    const message = messages[locale]?.get(key)
    if (message !== undefined) return fill(message, facts, locale)
    console.error(`No words for ${key} in ${locale}.`)
    return key
  }

/** Says a message in the language of now, also where its key is data (a check's, a finding's). */
export const message: Words = (key, facts) => wordsIn(language.locale)(key, facts)

/** Every message as a function of its facts. */
export const m = new Proxy(
  {},
  { get: (_messages, key: string) => (facts?: Facts) => message(key, facts) },
) as Messages
