import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { basename, dirname, join } from 'node:path'
import type { Plugin } from 'vite'
import { asData } from './data.ts'

type Tree = { readonly [key: string]: string | Tree }

/** Sections of words that only pages beside the lab need, and parts that a click asks for (`later.ts`). */
const late = [
  'build',
  'debug',
  'inside',
  'net',
  'openRoberta',
  'projects',
  'q',
  'robot',
  'share',
  'shelf',
  'tour',
  'worldName',
]

/** What goes wrong with the blocks of a pack, with files, and while a world is built. */
const lateProblems =
  /^problem\.(link\w+|nothingToTake|homeTooBig|notJson|tooBig|notAProject|newerVersion|notKept|damaged|tooMuch|notXml|unsafeXml|notOpenRoberta|otherRobot|tooManyBlocks|tooManyThings|tooDeep|tooManyNeurons|tooManyInLayer|noSuchStation|startIsGoal|emptyObstacle|groupsFromTo|fewReadings|noGroupsYet|noSuchGroup|picture\w+|sceneNotJson|notAScene|isAProject)\./

/** Words of blocks that come in a pack have its names; what their lists offer comes with them. */
const ofPacks =
  /^(block\.(ai_q_|rl_|ai_sorting_|ai_nn_hidden)|choice\.(relu|sigmoid|tanh|threshold|linear|MAP_\w+|slowly|medium|fast|aLot|aLittle|rarely|often|sometimes|group\w+)$)/

/** What a second robot is called is said in the world. */
const ofCrew = /^robots\.(?!name$)/

/** What the clock says comes with the bar of time; its button is always there. */
const ofTime = /^time\.(?!open|close)/

/** The settings of a device. */
const ofComfort = /^comfort\.(projector|quiet|letters|aloud)/

/** What stands on a card, in the menus and in what the lab says when something has gone wrong or well. */
const ofDialogs =
  /^lab\.(need|conflict|gone|keepCopy|loadNewer|fullT|refused|outdated|blocked|tooMuch|showBlock|saveRaw|success|rays|trail|onPaper|openFile|saveFile|saveOpenRoberta|cardNumber|youNeed|minutes|pairs|fromGrade|firstDrive|mission|further)/

/** Home says it when it has found a new version: its words come then. */
const ofVersion = /^offline\.newVersion/

const isLate = (key: string) =>
  late.includes(key.split('.')[0]!) ||
  ofPacks.test(key) ||
  ofCrew.test(key) ||
  lateProblems.test(key) ||
  ofTime.test(key) ||
  ofDialogs.test(key) ||
  ofComfort.test(key) ||
  ofVersion.test(key)

/** What a block does is asked for when a hand rests on one. */
const isHelp = (key: string) => /^block\.\w+\.help$/.test(key)

/** No page says what a block is called: its words stand on it. */
const isSaid = (key: string) => !/^(\$schema|block\.\w+\.name)$/.test(key)

/** Pages that the lab never shows have a table of their own: sorting, the learning materials, what this lab is. */
const partOf = (key: string) =>
  /^(about|sorting|materials)\./.test(key) ? 'sorting' : isLate(key) ? 'late' : 'first'

/** `content/words/<language>.json?first`, `?late` and `?sorting`, `expert/<language>.json?expert`: words of one language, flat (`world.lost`). */
const tables: Plugin = {
  name: 'tables-of-words',
  enforce: 'pre',
  load: {
    filter: { id: /\.json\?(first|late|sorting|expert)$/ },
    async handler(id) {
      const [file, part] = id.split('?') as [string, string]
      this.addWatchFile(file)
      const all = (await entriesOf(file)).filter(([key]) => isSaid(key) && !isHelp(key))
      const words = Object.fromEntries(all.filter(([key]) => part === 'expert' || partOf(key) === part))
      // A string is read faster than an object of code.
      const code = `export default JSON.parse(${JSON.stringify(JSON.stringify(words))})`
      return { code, map: null, moduleType: 'js' }
    },
  },
}

/** `content/words/<language>.json?help`: brings what every block does, the expert pack's too, as data beside the scripts. */
const tablesOfHelp: Plugin = {
  name: 'tables-of-help',
  enforce: 'pre',
  load: {
    filter: { id: /\.json\?help$/ },
    async handler(id) {
      const file = id.split('?')[0]!
      const language = basename(file)
      const files = [file, join(dirname(file), 'expert', language)]
      for (const file of files) this.addWatchFile(file)
      const entries = (await Promise.all(files.map(entriesOf))).flat().filter(([key]) => isHelp(key))
      return asData(this, `help-${language}`, Object.fromEntries(entries))
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
    filter: { code: /from '#words\/generated\/messages\.js'/ },
    handler: (code) => ({
      code: code.replace(
        /import (?:\* as m|\{ m \}) from '#words\/generated\/messages\.js'/,
        "import { m } from '#words/say.ts'",
      ),
      map: null,
    }),
  },
}

export const words: readonly Plugin[] = [tables, tablesOfHelp, blocklyWords, messagesByKey]

const entriesOf = async (file: string) =>
  Object.entries(flat(JSON.parse(await readFile(file, 'utf8')) as Tree))

const flat = (tree: Tree, before = ''): { readonly [key: string]: string } =>
  Object.fromEntries(
    Object.entries(tree).flatMap(([key, word]) =>
      typeof word === 'string' ? [[before + key, word]] : Object.entries(flat(word, `${before}${key}.`)),
    ),
  )
