import { existsSync, globSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import type { Plugin } from 'vite'
import { readAlignment } from '../../packages/materials/items/alignment.ts'
import { readItem } from '../../packages/materials/items/item.ts'
import { readReferences } from '../../packages/materials/items/references.ts'
import { newBlocks, type ProgramsOfCard } from '../../packages/materials/items/newBlocks.ts'
import { readItemText } from '../../packages/materials/items/itemText.ts'
import type { ItemNode, ItemText } from '../../packages/materials/items/types.ts'
import { nodesOf } from '../../packages/materials/items/walk.ts'
import type { CardProgram } from '../../packages/materials/types.ts'
import { readQuestion, readQuestionText } from '../../packages/materials/questions/question.ts'

const content = join(import.meta.dirname, '../../content')
const files = (pattern: string) => globSync(pattern, { cwd: content }).sort()
const text = (...path: string[]) => readFileSync(join(content, ...path), 'utf8')
/** A text in a language; in English where it has none. */
const textIn = (folder: string, language: string) =>
  text(folder, `${existsSync(join(content, folder, `${language}.md`)) ? language : 'en'}.md`)
const json = (...path: string[]): unknown => JSON.parse(text(...path))
const foldersWith = (file: string) => files(`materials/*/*/${file}`).map(dirname)

/** `01-one-day`: the number of an item among those of its kind. */
const numberOf = (folder: string) => Number(/^\d+/.exec(basename(folder))?.[0])

const items = () =>
  foldersWith('item.json').map((folder) => ({
    ...readItem(json(folder, 'item.json')),
    number: numberOf(folder),
  }))
const questions = () =>
  foldersWith('question.json').map((folder) => readQuestion(json(folder, 'question.json')))

/** A picture lies beside its text: its whole path below `materials` tells it from others of its name. */
const withPaths = (folder: string, item: ItemText): unknown =>
  JSON.parse(
    JSON.stringify(item, (_, node: ItemNode) =>
      node?.type === 'image' ? { ...node, file: `${folder.replace('materials/', '')}/${node.file}` } : node,
    ),
  )

/** Words of all items and questions in a language, by `kind/id` and by id. */
const textsIn = (language: string) => ({
  items: Object.fromEntries(
    foldersWith('item.json').map((folder) => {
      const { kind, id } = readItem(json(folder, 'item.json'))
      return [`${kind}/${id}`, withPaths(folder, readItemText(textIn(folder, language)))]
    }),
  ),
  questions: Object.fromEntries(
    foldersWith('question.json').map((folder) => {
      const { id } = readQuestion(json(folder, 'question.json'))
      return [id, readQuestionText(textIn(folder, language))]
    }),
  ),
})

/** Programs of cards that an item or a question shows, by `card/file`: start programs come with their cards. */
function shownPrograms() {
  const named = new Set<string>()
  for (const folder of foldersWith('item.json'))
    for (const node of nodesOf(readItemText(text(folder, 'en.md')))) {
      if (node.type !== 'embed') continue
      if ('file' in node.embed) named.add(`${node.embed.card}/${node.embed.file}`)
      if (node.embed.kind === 'way') named.add(`${node.embed.card}/solution`)
    }
  for (const { run } of questions()) if ('file' in run) named.add(`${run.card}/${run.file}`)
  return Object.fromEntries(
    [...named].filter((name) => !name.endsWith('/start')).map((name) => [name, programOf(name)]),
  )
}

function programOf(name: string): unknown {
  const [card = '', ...file] = name.split('/')
  const folder = files('cards/*/*').find((one) => basename(one).replace(/^\d+-/, '') === card)
  return json(folder ?? card, `${file.join('/')}.json`)
}

/** What all cards begin with and end with, in the order in which they are met. */
const programsOfCards = () =>
  files('cards/*/*/solution.json').map((file) => {
    const folder = dirname(file)
    const program = (name: string) => json(folder, `${name}.json`) as CardProgram
    const programs: ProgramsOfCard = { start: program('start'), solution: program('solution') }
    return [basename(folder).replace(/^\d+-/, ''), programs] as const
  })

/** `content:materials/<part>`: learning materials as data, read and checked when the product is built. */
const parts: { readonly [part: string]: () => unknown } = {
  heads: () => ({ items: items(), questions: questions() }),
  alignment: () => readAlignment(json('materials/alignment.json')),
  references: () => readReferences(json('materials/references.json')),
  programs: shownPrograms,
  blocks: () => newBlocks(programsOfCards()),
}

// A string is read faster than an object of code.
const moduleOf = (data: unknown) => ({
  code: `export default JSON.parse(${JSON.stringify(JSON.stringify(data))})`,
  map: null,
  moduleType: 'js' as const,
})

/** `content:materials/…`, and `content/words/<language>/app.json?items`: the words of all items in a language. */
export const materials: Plugin = {
  name: 'learning-materials',
  enforce: 'pre',
  resolveId: { filter: { id: /^content:materials\// }, handler: (id) => `\0${id}` },
  load: {
    filter: { id: /^\0content:materials\/|\.json\?items$/ },
    handler(id) {
      for (const file of files('materials/{*,*/*/*}.{json,md}')) this.addWatchFile(join(content, file))
      const part = /^\0content:materials\/(\w+)$/.exec(id)?.[1]
      return moduleOf(part ? parts[part]!() : textsIn(basename(dirname(id))))
    },
  },
}
