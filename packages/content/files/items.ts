import { readdirSync } from 'node:fs'
import type { ItemTexts, NumberedItem } from '../catalogue.ts'
import { readItem } from '../schema/item.ts'
import { readItemText } from '../schema/itemText.ts'
import type { ItemNode, ItemText } from '../schema/itemTypes.ts'
import { readQuestion, readQuestionText } from '../schema/question.ts'
import type { Question } from '../schema/questionTypes.ts'
import { readPacks, readSynonyms } from '../schema/packs.ts'
import { each, named, numberOf, once, type Folder } from './folder.ts'

/** Learning materials and the questions about what Bo will do. */
export function itemsIn(content: Folder) {
  const items = once(() =>
    content.foldersWith('materials/*/*/item.json').flatMap((folder) => {
      const item = named(folder, readItem(content.json(folder, 'item.json')))
      return levelsOf(folder, { ...item, number: numberOf(folder) })
    }),
  )
  const questions = once(() =>
    content
      .foldersWith('materials/*/*/question.json')
      .map((folder): readonly [string, Question] => [
        folder,
        named(folder, readQuestion(content.json(folder, 'question.json'))),
      ]),
  )
  const synonyms = once(() => readSynonyms(content.json('materials/synonyms.json')))
  const folderOf = (id: string): string => [...items(), ...questions()].find(([, one]) => one.id === id)![0]

  /** A text in a language; in English where it has none. */
  const textIn = (folder: string, language: string) =>
    content.text(folder, `${content.has(folder, `${language}.md`) ? language : 'en'}.md`)

  const itemTexts = each((language): ItemTexts => ({
    items: Object.fromEntries(
      items().map(([folder, { kind, id }]) => [
        `${kind}/${id}`,
        withPaths(folder, readItemText(textIn(folder, language))),
      ]),
    ),
    synonyms: synonyms()[language] ?? [],
    questions: Object.fromEntries(
      questions().map(([folder, { id }]) => [id, readQuestionText(textIn(folder, language))]),
    ),
  }))

  return {
    ...{ itemTexts, folderOf },
    items: once(() => items().map(([, item]) => item)),
    packs: once(() => readPacks(content.json('materials/packs.json'))),
    questions: once(() => questions().map(([, question]) => question)),
    picturesOf: (id: string) =>
      readdirSync(content.path(folderOf(id))).filter((file) => /\.(svg|png)$/.test(file)),
  }
}

/** An item, and each of its other reading levels as one: with a text, grades and a code of its own. */
function levelsOf(folder: string, item: NumberedItem): readonly (readonly [string, NumberedItem])[] {
  const { levels, ...middle } = item
  if (!levels) return [[folder, item]]
  const others = Object.entries(levels).map(
    ([level, grades]) =>
      [
        `${folder}/${level}`,
        { ...middle, grades, id: `${item.id}-${level}`, code: `${item.code}${level}` },
      ] as const,
  )
  return [[folder, { ...item, code: `${item.code}b` }], ...others]
}

/** A picture lies beside its text: its path below `content/materials` tells it from others of its name. */
function withPaths(folder: string, text: ItemText): ItemText {
  const below = folder.replace('materials/', '')
  return JSON.parse(
    JSON.stringify(text, (_, node: ItemNode | null) =>
      node?.type === 'image' ? { ...node, file: `${below}/${node.file}` } : node,
    ),
  ) as ItemText
}
