import { readFile } from 'node:fs/promises'
import type { Plugin } from 'vite'

type Tree = { readonly [key: string]: string | Tree }

/** `content/words/<language>.json?table`: all words of one language, flat (`world.lost`). */
const tables: Plugin = {
  name: 'tables-of-words',
  enforce: 'pre',
  load: {
    filter: { id: /\.json\?table$/ },
    async handler(id) {
      const file = id.split('?')[0]!
      this.addWatchFile(file)
      const words = flat(JSON.parse(await readFile(file, 'utf8')) as Tree)
      // A string is read faster than an object of code.
      const code = `export default JSON.parse(${JSON.stringify(JSON.stringify(words))})`
      return { code, map: null, moduleType: 'js' }
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

export const words: readonly Plugin[] = [tables, messagesByKey]

const flat = (tree: Tree, before = ''): { readonly [key: string]: string } =>
  Object.fromEntries(
    Object.entries(tree).flatMap(([key, word]) =>
      typeof word === 'string' ? [[before + key, word]] : Object.entries(flat(word, `${before}${key}.`)),
    ),
  )
