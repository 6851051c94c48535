import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import type { Plugin } from 'vite'

type Tree = { readonly [key: string]: string | Tree }

/** Sections of words that only pages beside the lab need, and parts that a click asks for (`later.ts`). */
const late = ['about', 'build', 'debug', 'projects', 'q', 'robot', 'share', 'shelf', 'tour']

/** What goes wrong with the blocks of a pack, and while a world is built. */
const lateProblems =
  /^problem\.(noSuchStation|startIsGoal|emptyObstacle|groupsFromTo|fewReadings|noGroupsYet|noSuchGroup|picture\w+|sceneNotJson|notAScene|isAProject)\./

/** Words of blocks that come in a pack have its names. */
const isLate = (key: string) =>
  late.includes(key.split('.')[0]!) || /^block\.(ai_q_|rl_|ai_sorting_)/.test(key) || lateProblems.test(key)

/** No page says what a block is called: its words stand on it. */
const isSaid = ([key]: readonly [string, string]) => !/^block\.\w+\.name$/.test(key)

/** The page for sorting has a table of its own. */
const partOf = (key: string) => (key.startsWith('sorting.') ? 'sorting' : isLate(key) ? 'late' : 'first')

/** `content/words/<language>.json?first`, `?late` and `?sorting`, `expert/<language>.json?expert`: words of one language, flat (`world.lost`). */
const tables: Plugin = {
  name: 'tables-of-words',
  enforce: 'pre',
  load: {
    filter: { id: /\.json\?(first|late|sorting|expert)$/ },
    async handler(id) {
      const [file, part] = id.split('?') as [string, string]
      this.addWatchFile(file)
      const all = Object.entries(flat(JSON.parse(await readFile(file, 'utf8')) as Tree)).filter(isSaid)
      const words = Object.fromEntries(all.filter(([key]) => part === 'expert' || partOf(key) === part))
      // A string is read faster than an object of code.
      const code = `export default JSON.parse(${JSON.stringify(JSON.stringify(words))})`
      return { code, map: null, moduleType: 'js' }
    },
  },
}

const blocklyCore = createRequire(import.meta.url).resolve('blockly/core')
let asked: Promise<ReadonlySet<string>> | undefined

/** Keys that Blockly's core asks for; the others belong to its own blocks and to plugins. */
const askedByCore = () =>
  (asked ??= readFile(blocklyCore.replace(/core[\w-]*\.js$/, 'blockly_compressed.js'), 'utf8').then(
    (code) => new Set(code.match(/\b[A-Z][A-Z0-9_]+\b/g)),
  ))

/** `content/words/blockly/<language>.json?core`: Blockly's own words, as far as its core says them. */
const blocklyWords: Plugin = {
  name: 'words-of-blockly',
  enforce: 'pre',
  load: {
    filter: { id: /\.json\?core$/ },
    async handler(id) {
      const file = id.split('?')[0]!
      this.addWatchFile(file)
      const all = Object.entries(JSON.parse(await readFile(file, 'utf8')) as { [key: string]: string })
      const keys = await askedByCore()
      const words = Object.fromEntries(all.filter(([key]) => keys.has(key)))
      return { code: `export default ${JSON.stringify(words)}`, map: null, moduleType: 'js' }
    },
  },
}

/**
 * A message as Paraglide compiles it is a module with its words in every language; a page speaks one. Paraglide keeps the types;
 * in what is built a message is its key, and its words come from the table of the language.
 */
const messagesByKey: Plugin = {
  name: 'messages-by-key',
  enforce: 'pre',
  transform: {
    filter: { code: /from '#lib\/words\/generated\/messages\.js'/ },
    handler: (code) => ({
      code: code.replace(
        /import (?:\* as m|\{ m \}) from '#lib\/words\/generated\/messages\.js'/,
        "import { m } from '#lib/words/say.ts'",
      ),
      map: null,
    }),
  },
}

export const words: readonly Plugin[] = [tables, blocklyWords, messagesByKey]

const flat = (tree: Tree, before = ''): { readonly [key: string]: string } =>
  Object.fromEntries(
    Object.entries(tree).flatMap(([key, word]) =>
      typeof word === 'string' ? [[before + key, word]] : Object.entries(flat(word, `${before}${key}.`)),
    ),
  )
