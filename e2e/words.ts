import { globSync, readFileSync } from 'node:fs'
import { basename } from 'node:path'

export const languages = ['en', 'de'] as const
export type Language = (typeof languages)[number]

/**
 * The languages in which the tests of a file run: one of them, the same at every run and spread evenly over the
 * files, or all where `BOTGARTEN_LANGUAGES` is `all`. Behaviour does not depend on the language; that words fit on
 * every screen in every language has a test of its own.
 */
export function languagesOf(file: string): readonly Language[] {
  if (process.env['BOTGARTEN_LANGUAGES'] === 'all') return languages
  const sum = [...basename(file)].reduce((sum, letter) => sum + letter.charCodeAt(0), 0)
  return [languages[sum % languages.length]!]
}

type Facts = { readonly [name: string]: string | number }
type Tree = string | { readonly [key: string]: Tree }

const read = (file: string) =>
  JSON.parse(readFileSync(new URL(`../content/words/${file}.json`, import.meta.url), 'utf8')) as Tree
/** Those of every page, and those of the whole block language. */
const words = { en: [read('en'), read('expert/en')], de: [read('de'), read('expert/de')] }

function find(tree: Tree, key: string): string | undefined {
  let found: Tree | undefined = tree
  for (const part of key.split('.')) found = typeof found === 'object' ? found[part] : undefined
  return typeof found === 'string' ? found : undefined
}

/** What the screen says for a message key (`lab.start`) in a language. Throws where nobody wrote it. */
export function say(language: Language, key: string, facts: Facts = {}): string {
  const found = words[language].map((tree) => find(tree, key)).find((said) => said !== undefined)
  if (found === undefined) throw new Error(`No word for ${key} in ${language}`)
  return found.replace(/\{(\w+)\}/g, (gap, name: string) => String(facts[name] ?? gap))
}

/** What a card's check is called in a language. Throws where nobody wrote it. */
export function sayCheck(language: Language, card: string, id: string): string {
  const cards = new URL('../content/cards/', import.meta.url).pathname
  const [file] = globSync(`${cards}*/*-${card}/${language}.md`)
  const said = file && new RegExp(`^- ${id}: (.+)$`, 'm').exec(readFileSync(file, 'utf8'))?.[1]
  if (!said) throw new Error(`No word for the check ${id} of ${card} in ${language}`)
  return said
}
