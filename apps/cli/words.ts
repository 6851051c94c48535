import { fill, type Facts, type Message, type Table } from '@botgarten/messages'
import { languagesIn, tableOf, wordsOf } from '@botgarten/messages/folder'
import type cli from '../../content/words/en/cli.json'
import type doctor from '../../content/words/en/doctor.json'

export type { Facts }

/** A language is a folder of `content/words`. */
export const languages = languagesIn()
export type Language = string

type KeysOf<Words> = {
  [Name in keyof Words & string]: Words[Name] extends string | readonly unknown[]
    ? Name
    : `${Name}.${KeysOf<Words[Name]>}`
}[keyof Words & string]

/** A sentence of the command line: `call.needsMap`. */
export type Key = KeysOf<typeof cli> | KeysOf<Omit<typeof doctor, '$schema'>>

/** The language of the machine, as far as there are words in it. */
export function languageOfMachine(): Language {
  const language = new Intl.Locale(Intl.DateTimeFormat().resolvedOptions().locale).language
  return languages.includes(language) ? language : 'en'
}

let spoken = languageOfMachine()

/** Every sentence of this call is said in it. */
export function speak(language: Language): void {
  spoken = language
}

/** Says a sentence of the command line in the language of this call. */
export const message = (key: Key, facts: Facts = {}): string => filled(own()[key] ?? key, facts)

/** The command line's own word, where it has one. */
export function ownWord(key: string): string | undefined {
  const word = own()[key]
  return word === undefined ? undefined : filled(word, {})
}

/** A message of the lab in the language of this call; its key where there is none. */
export const labMessage = (key: string, facts: Facts = {}): string => filled(all()[key] ?? key, facts)

/** Says what is wrong with a program or a file as the lab does; the name alone where the lab has no words for it. */
export function problemMessage(problem: string, facts: Facts = {}): string {
  const ours = own()[`project.${problem}`]
  if (ours !== undefined) return filled(ours, facts)
  const words = all()
  const [title, text] = [words[`problem.${problem}.title`], words[`problem.${problem}.text`]]
  return title && text ? `${filled(title, facts)} ${filled(text, facts)}` : problem
}

/** A message of a file in a language of its own: of a document that says all in each. */
export const messageOf = (file: string, language: Language, key: string, facts: Facts): string =>
  fill(tableOf(file, language)[key]!, facts, language)

const filled = (message: Message, facts: Facts) => fill(message, facts, spoken)

/** Tables are read when they are asked for. */
const cached = (read: (language: Language) => Table) => {
  const tables = new Map<Language, Table>()
  return () => {
    const table = tables.get(spoken) ?? read(spoken)
    tables.set(spoken, table)
    return table
  }
}
const own = cached((language) => ({ ...tableOf('cli', language), ...tableOf('doctor', language) }))
const all = cached((language) => wordsOf(language))
