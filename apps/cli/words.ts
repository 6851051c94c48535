import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type cli from '../../content/words/cli/en.json'

export const languages = ['de', 'en'] as const
export type Language = (typeof languages)[number]

type Tree = { readonly [name: string]: string | Tree }
type KeysOf<Words> = {
  [Name in keyof Words & string]: Words[Name] extends string ? Name : `${Name}.${KeysOf<Words[Name]>}`
}[keyof Words & string]

/** A sentence of the command line: `call.needsMap`. */
export type Key = KeysOf<typeof cli>
export type Facts = { readonly [name: string]: string | number }

/** The language of the machine, as far as there are words in it. */
export const languageOfMachine = (): Language =>
  /^de\b/.test(Intl.DateTimeFormat().resolvedOptions().locale) ? 'de' : 'en'

let spoken = languageOfMachine()

/** Every sentence of this call is said in it. */
export function speak(language: Language): void {
  spoken = language
}

/** Says a sentence of the command line in the language of this call. */
export const say = (key: Key, facts: Facts = {}): string => fill(find('cli', key) ?? key, facts)

/** The command line's own word, where it has one. */
export const ownWord = (key: string): string | undefined => find('cli', key)

/** Says what is wrong with a program or a file as the lab does; the name alone where the lab has no words for it. */
export function sayProblem(problem: string, facts: Facts = {}): string {
  const own = find('cli', `project.${problem}`)
  if (own !== undefined) return fill(own, facts)
  const parts = ['title', 'text'].map(
    (part) => find('', `problem.${problem}.${part}`) ?? find('expert', `problem.${problem}.${part}`),
  )
  return parts.includes(undefined) ? problem : fill(parts.join(' '), facts)
}

const fill = (sentence: string, facts: Facts) =>
  sentence.replace(/\{(\w+)\}/g, (all, name: string) =>
    Object.hasOwn(facts, name) ? String(facts[name]) : all,
  )

const tables = new Map<string, Tree>()

/** The words of a folder of `content/words`, read when they are asked for. */
function tableOf(folder: string): Tree {
  const file = join(import.meta.dirname, '../../content/words', folder, `${spoken}.json`)
  const known = tables.get(file)
  if (known) return known
  const table = JSON.parse(readFileSync(file, 'utf8')) as Tree
  tables.set(file, table)
  return table
}

function find(folder: string, key: string): string | undefined {
  let found: string | Tree | undefined = tableOf(folder)
  for (const name of key.split('.'))
    found = typeof found === 'object' && Object.hasOwn(found, name) ? found[name] : undefined
  return typeof found === 'string' ? found : undefined
}
