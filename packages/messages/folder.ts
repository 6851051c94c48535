// The folder content/words: a folder a language, in it a file a feature.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Message } from './message.ts'
import { flat, type Table, type Tree } from './table.ts'

export const wordsFolder = join(import.meta.dirname, '../../content/words')

/**
 * The languages that are promised complete: they have every message, card and sheet. Any other language may lack some; the
 * first of these that has the message stands in for it.
 */
export const completeLanguages = ['en', 'de'] as const

/** The languages that a text has to be in, and every other that it is in. */
export const languagesOf = (text: { readonly [language: string]: unknown }): readonly string[] => [
  ...new Set([...completeLanguages, ...Object.keys(text)]),
]

export const languagesIn = (folder = wordsFolder): readonly string[] =>
  readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => name)
    .sort()

const filesOf = (language: string, folder: string) =>
  readdirSync(join(folder, language))
    .filter((name) => name.endsWith('.json'))
    .map((name) => name.slice(0, -'.json'.length))

/** Files of messages, by name without the ending: every one that some language has. */
export const filesIn = (folder = wordsFolder): readonly string[] =>
  [...new Set(languagesIn(folder).flatMap((language) => filesOf(language, folder)))].sort()

/** What a language itself says in a file; nothing where it has no such file. */
export function ownTableOf(file: string, language: string, folder = wordsFolder): Table {
  if (!filesOf(language, folder).includes(file)) return {}
  return flat(JSON.parse(readFileSync(join(folder, language, `${file}.json`), 'utf8')) as Tree)
}

/** All messages of a file in a language; what it lacks in the language that it falls back to. */
export function tableOf(file: string, language: string, folder = wordsFolder): Table {
  const own = ownTableOf(file, language, folder)
  const others = completeLanguages.filter(
    (other) => other !== language && languagesIn(folder).includes(other),
  )
  const borrowed = others.map((other) =>
    Object.entries(ownTableOf(file, other, folder)).map(([key, message]) => [key, inWords(message, other)]),
  )
  return { ...(Object.fromEntries(borrowed.reverse().flat()) as Table), ...own }
}

/** One and many are told apart by the rules of the language that the sentence is in. */
const inWords = (message: Message, locale: string): Message =>
  typeof message === 'string' ? message : [{ ...message[0], locale }]

/** Every message of a language, those of its files together. */
export const wordsOf = (language: string, folder = wordsFolder): Table =>
  Object.assign(
    {},
    ...filesIn(folder)
      .filter((file) => file !== 'blockly')
      .map((file) => tableOf(file, language, folder)),
  ) as Table
