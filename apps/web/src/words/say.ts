import { language, type Locale } from './language.svelte.ts'

type Table = { readonly [key: string]: string }
type Facts = { readonly [name: string]: string | number }

/** Says a message key; unknown keys come back as they are, so that a missing word is seen, not a crash. */
export type Words = (key: string, facts?: Facts) => string

const files = {
  first: import.meta.glob<Table>('../../../../content/words/*.json', {
    query: '?first',
    import: 'default',
  }),
  late: import.meta.glob<Table>('../../../../content/words/*.json', { query: '?late', import: 'default' }),
  sorting: import.meta.glob<Table>('../../../../content/words/*.json', {
    query: '?sorting',
    import: 'default',
  }),
  expert: import.meta.glob<Table>('../../../../content/words/expert/*.json', {
    query: '?expert',
    import: 'default',
  }),
  help: import.meta.glob<() => Promise<Table>>('../../../../content/words/*.json', {
    query: '?help',
    import: 'default',
    eager: true,
  }),
}
type Part = keyof typeof files
const tables = new Map<string, Table>()

async function fetchPart(part: Part, locale: Locale): Promise<void> {
  const name = `${part} ${locale}`
  const folder = part === 'expert' ? 'expert/' : ''
  const file = `../../../../content/words/${folder}${locale}.json`
  if (!tables.has(name)) tables.set(name, await files[part][file]!())
}

/** Brings the words of every page, in the language of now and in each that will be spoken: before anything is said. */
export const fetchWords = (): Promise<void> => fetchAlways('first')

/** Brings the words of what comes late, as `apps/web/words.ts` names it: before any of it is shown. */
export const fetchLateWords = (): Promise<void> => fetchAlways('late')

/** Brings the words of pages beside the lab: sorting, the learning materials, what this lab is. No other page has them. */
export const fetchSortingWords = (): Promise<void> => fetchAlways('sorting')

/** Brings the words of the expert pack's blocks: before one of them is shown. */
export const fetchExpertWords = (): Promise<void> => fetchAlways('expert')

/** Brings what every block does: before a hand that rests on one is told. */
export const fetchHelp = (): Promise<void> => fetchAlways('help')

/**
 * A part that comes late (`later.ts`), once its words have come too.
 * @param lost takes back the wish for it where it cannot be brought, so that the next press asks anew
 */
export async function withWords<Part>(part: Promise<Part>, lost?: () => void): Promise<Part> {
  try {
    return (await Promise.all([part, fetchLateWords()]))[0]
  } catch (cause) {
    lost?.()
    throw cause
  }
}

const parts = Object.keys(files) as readonly Part[]
const bringing = Object.fromEntries(
  parts.map((part) => [part, (locale: Locale) => fetchPart(part, locale)]),
) as { readonly [part in Part]: (locale: Locale) => Promise<void> }

function fetchAlways(part: Part): Promise<void> {
  language.needs(bringing[part])
  return bringing[part](language.locale)
}

const find = (locale: Locale, key: string): string | undefined => {
  for (const part of parts) {
    const word = tables.get(`${part} ${locale}`)?.[key]
    if (word !== undefined) return word
  }
}

/** Is there a message of this key? */
export const isSaid = (key: string): boolean => find(language.locale, key) !== undefined

/** Words of a language that has been fetched. */
export const wordsIn =
  (locale: Locale): Words =>
  (key, facts = {}) => {
    const word = find(locale, key)
    if (word === undefined) console.error(`No words for ${key} in ${locale}.`)
    return word?.replace(/\{(\w+)\}/g, (gap, name: string) => String(facts[name] ?? gap)) ?? key
  }

/** Says a message in the language of now, also where its key is data (a check's, a finding's). */
export const say: Words = (key, facts) => wordsIn(language.locale)(key, facts)

/** What `generated/messages.js` is in the built product: a function for every key. */
export const m = new Proxy<{ readonly [key: string]: (facts?: Facts) => string }>(
  {},
  { get: (_messages, key: string) => (facts?: Facts) => say(key, facts) },
)
