import { statSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { filesIn, languagesIn, ownTableOf, tableOf, wordsFolder } from '@botgarten/messages/folder'
import type { Table } from '@botgarten/messages'
import type { Plugin } from 'vite'

/** Files that no screen says: only the command line does. */
const ofCommands = 'cli'
/** Blockly's own words, which it asks for itself. */
const ofBlockly = 'blockly'

/** Files with messages that only pages of teachers show. */
export const ofTeachers: readonly string[] = ['teacher', 'doctor']

/** Is a module one of them? */
export function isForTeachers(id: string): boolean {
  const [, file] = /^\0content:words\/[^/]+\/([^/]+)$/.exec(id) ?? []
  return file !== undefined && ofTeachers.includes(file)
}

/** The files whose messages the screens say. */
export const filesOfScreens = (folder = wordsFolder): readonly string[] =>
  filesIn(folder).filter((file) => file !== ofCommands && file !== ofBlockly)

/**
 * `content:words`: the languages and the files of messages, each as a module of its own, `content:words/de/app`. A module
 * holds every message of its file: what the language lacks it says in the language that it falls back to.
 */
const tables = (folder: string, together = false): Plugin => ({
  name: 'words',
  enforce: 'pre',
  resolveId: { filter: { id: /^content:words(\/|$)/ }, handler: (id) => `\0${id}` },
  load: {
    filter: { id: /^\0content:words(\/|$)/ },
    async handler(id) {
      const [language, file] = id.split('/').slice(1)
      if (!language || !file) return { code: await indexOf(folder, together), map: null, moduleType: 'js' }
      for (const language of languagesIn(folder)) this.addWatchFile(join(folder, language, `${file}.json`))
      const code = `export default ${await wordsAsCode(folder, language, file)}`
      return { code, map: null, moduleType: 'js' }
    },
  },
})

/** Messages of one language that are fewer than this many bytes come together: a request costs more than they do. */
const smallTable = 8_000

/** Name of the chunk of a language's small files; null for what is none of them. */
export function chunkOfWords(id: string): string | null {
  const [, language, file] = /^\0content:words\/([^/]+)\/([^/]+)$/.exec(id) ?? []
  if (!language || !file) return null
  // A language that lacks the file has what it falls back to; the first fallback has them all.
  const size = statSync(join(wordsFolder, 'en', `${file}.json`)).size
  return size < smallTable ? `words-${language}` : null
}

/** What a language is called in itself. A browser would take some milliseconds of every start to say it. */
const nameOf = (language: string) => new Intl.DisplayNames([language], { type: 'language' }).of(language)

/** A string is read faster than an object of code. */
async function wordsAsCode(folder: string, language: string, file: string): Promise<string> {
  const words = await (file === ofBlockly
    ? wordsOfBlockly(folder, language)
    : tableOf(file, language, folder))
  return `JSON.parse(${JSON.stringify(JSON.stringify(words))})`
}

/** How a file of words is asked for: as a module of its own, or at once, beside all others. */
const loadOf = async (folder: string, language: string, file: string, together: boolean): Promise<string> =>
  together
    ? `async () => ({ default: ${await wordsAsCode(folder, language, file)} })`
    : `() => import("content:words/${language}/${file}")`

async function indexOf(folder: string, together: boolean): Promise<string> {
  const languages = languagesIn(folder)
  const files = [...filesOfScreens(folder), ofBlockly]
  const tables = await Promise.all(
    languages.map(async (language) => {
      const loads = files.map(
        async (file) => `${JSON.stringify(file)}: ${await loadOf(folder, language, file, together)}`,
      )
      return `${JSON.stringify(language)}: { ${(await Promise.all(loads)).join(', ')} }`
    }),
  )
  const names = Object.fromEntries(languages.map((language) => [language, nameOf(language)]))
  return `export const languages = ${JSON.stringify(languages)}
export const names = ${JSON.stringify(names)}
export const files = { ${tables.join(', ')} }`
}

const require = createRequire(import.meta.url)
const blocklyCore = require.resolve('blockly/core')
let asked: Promise<ReadonlySet<string>> | undefined

/** Keys that Blockly's core asks for; the others belong to its own blocks and to plugins. */
const askedByCore = () =>
  (asked ??= readFile(blocklyCore.replace(/core[\w-]*\.js$/, 'blockly_compressed.js'), 'utf8').then(
    (code) => new Set(code.match(/\b[A-Z][A-Z0-9_]+\b/g)),
  ))

/** Blockly's own words, as far as its core says them: ours, else those that come with Blockly in this language. */
async function wordsOfBlockly(folder: string, language: string): Promise<Table> {
  const keys = await askedByCore()
  const own = ownTableOf(ofBlockly, language, folder)
  const theirs = comingWithBlockly(language)
  const all = Object.entries(tableOf(ofBlockly, language, folder)).filter(([key]) => keys.has(key))
  return Object.fromEntries(all.map(([key, words]) => [key, own[key] ?? theirs[key] ?? words]))
}

function comingWithBlockly(language: string): { readonly [key: string]: string } {
  try {
    return require(`blockly/msg/${language}`) as { readonly [key: string]: string }
  } catch {
    return {}
  }
}

/** The words of a folder such as `content/words`, as the screens ask for them. */
export const wordsFrom = (folder: string): Plugin => tables(folder)

// A file of tests says all words from its start: a hundred modules would be a hundred questions to another process.
export const words = tables(wordsFolder, process.env['VITEST'] !== undefined)
