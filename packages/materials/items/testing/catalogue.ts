import { existsSync, globSync, readdirSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { addBlocks, definitions } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/learning'
import { expert } from '@botgarten/blocks/later'
import { readCard, type CardProgram } from '../../index.ts'
import { readMap } from '@botgarten/maps'
import { blocksIn } from '../blocksIn.ts'
import { readItem } from '../index.ts'
import type { Catalogue, CatalogueCard } from '../index.ts'

addBlocks(learning)
addBlocks(expert)

export const content = join(import.meta.dirname, '../../../../content')
export const read = (...path: string[]): unknown => JSON.parse(readFileSync(join(content, ...path), 'utf8'))

export const languages = globSync(join(content, 'words/*/app.json')).map((file) => basename(dirname(file)))

export const itemFolders = globSync('materials/*/*/item.json', { cwd: content }).sort().map(dirname)
export const cardFolders = globSync('cards/*/*/card.json', { cwd: content }).sort().map(dirname)

/** The folder of a card below `content`, by its id. */
export const cardFolder = (id: string): string =>
  cardFolders.find((folder) => basename(folder).replace(/^\d+-/, '') === id)!

/** What there is in `content`, as items name it. */
export const catalogue = (): Catalogue => ({
  items: new Set(itemFolders.map((folder) => readItem(read(folder, 'item.json')).id)),
  cards: new Map(cardFolders.map((folder) => cardOf(folder))),
  maps: new Map(readdirSync(join(content, 'maps')).map((id) => [id, mapOf(id)])),
  worlds: new Set(readdirSync(join(content, 'worlds'))),
  sets: new Set(readdirSync(join(content, 'things'))),
  blocks: new Set(Object.keys(definitions)),
  questions: new Set(
    globSync('materials/questions/*/question.json', { cwd: content }).map(
      (file) => (read(file) as { module: number }).module,
    ),
  ),
})

function cardOf(folder: string): [string, CatalogueCard] {
  const { id, playground, starts } = readCard(read(folder, 'card.json'))
  const files = globSync(['start.json', 'solution.json', 'wrong/*.json'], { cwd: join(content, folder) })
  const hasNet = (file: string) =>
    Object.values((read(folder, file) as CardProgram).brains).some(({ kind }) => kind === 'network')
  const named = (list: readonly string[]) => new Set(list.map((file) => file.replace(/\.json$/, '')))
  const ids = (file: string) => new Set(blocksIn(read(folder, file) as CardProgram).map((block) => block.id))
  const blocks = new Map(files.map((file) => [file.replace(/\.json$/, ''), ids(file)]))
  const nets = named(files.filter(hasNet))
  return [id, { playground, starts: starts.length, files: named(files), nets, blocks }]
}

function mapOf(id: string) {
  const { map } = readMap(readFileSync(join(content, 'maps', id, 'map.svg'), 'utf8'))
  const roads = map!.map.moves.flatMap((moves, from) => moves.map(({ to }) => `${from}-${to}`))
  return { stations: map!.map.moves.length, roads: new Set(roads) }
}

export const picturesIn = (folder: string): ReadonlySet<string> =>
  new Set(readdirSync(join(content, folder)).filter((file) => /\.(svg|png)$/.test(file)))

export const textOf = (folder: string, language: string): string => {
  const file = join(content, folder, `${language}.md`)
  return existsSync(file) ? readFileSync(file, 'utf8') : ''
}
