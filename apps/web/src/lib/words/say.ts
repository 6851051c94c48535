import { language, type Locale } from './language.svelte.ts'

type Table = { readonly [key: string]: string }
type Facts = { readonly [name: string]: string | number }

/** Says a message key; unknown keys come back as they are, so that a missing word is seen, not a crash. */
export type Words = (key: string, facts?: Facts) => string

const files = import.meta.glob<Table>('../../../../../content/words/*.json', {
  query: '?table',
  import: 'default',
})
const tables = new Map<Locale, Table>()

/** Brings the words of the language of now, or of another one, before anything is said in it. */
export async function fetchWords(locale: Locale = language.locale): Promise<void> {
  if (!tables.has(locale)) tables.set(locale, await files[`../../../../../content/words/${locale}.json`]!())
}

language.needs(fetchWords)

/** Words of a language that has been fetched. */
export const wordsIn =
  (locale: Locale): Words =>
  (key, facts = {}) =>
    tables.get(locale)?.[key]?.replace(/\{(\w+)\}/g, (gap, name: string) => String(facts[name] ?? gap)) ?? key

/** Says a message in the language of now, also where its key is data (a check's, a finding's). */
export const say: Words = (key, facts) => wordsIn(language.locale)(key, facts)

/** What `generated/messages.js` is in the built product: a function for every key. */
export const m = new Proxy<{ readonly [key: string]: (facts?: Facts) => string }>(
  {},
  { get: (_messages, key: string) => (facts?: Facts) => say(key, facts) },
)
