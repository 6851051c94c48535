import { language, type Locale } from '#words/language.svelte.ts'

type Table = { readonly [key: string]: string }

const files = import.meta.glob<Table>('../../../../../content/words/blockly/*.json', {
  query: '?core',
  import: 'default',
})
const tables = new Map<Locale, Table>()

/** Brings Blockly's own words: before an editor is made. */
export async function fetchBlocklyWords(locale: Locale = language.locale): Promise<void> {
  language.needs(fetchBlocklyWords)
  const file = `../../../../../content/words/blockly/${locale}.json`
  if (!tables.has(locale)) tables.set(locale, await files[file]!())
}

/** Blockly's own words in a language that has been fetched. */
export const blocklyWordsIn = (locale: Locale): Table => tables.get(locale) ?? {}
