import { files } from 'content:words'
import { language, type Locale } from '#words/language.svelte.ts'

type Table = { readonly [key: string]: string }

const tables = new Map<Locale, Table>()

/** Brings Blockly's own words: before an editor is made. */
export async function fetchBlocklyWords(locale: Locale = language.locale): Promise<void> {
  language.needs(fetchBlocklyWords)
  if (!tables.has(locale)) tables.set(locale, (await files[locale].blockly()).default as Table)
}

/** Blockly's own words in a language that has been fetched. */
export const blocklyWordsIn = (locale: Locale): Table => tables.get(locale) ?? {}
