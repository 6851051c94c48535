import { globSync, readFileSync } from 'node:fs'
import { addBlocks, definitions } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { expert } from '@botgarten/blocks/packs/expert'
import type { Question } from '../schema/questionTypes.ts'
import { content } from '../files.ts'
import { blocksIn } from '../items/blocksIn.ts'
import type { Nameable, NameableCard } from '../items/resolve.ts'

addBlocks(learning)
addBlocks(expert)

/** A file of content/ as it stands there; nothing where there is none. */
export const textOf = (...path: string[]): string => {
  const file = content.path(...path)
  return globSync(file).length > 0 ? readFileSync(file, 'utf8') : ''
}

/** All files of a card's programs, as `start`, `solution`, `wrong/<name>`. */
export const filesOf = (card: string): readonly string[] => [
  ...['start', 'solution'],
  ...content.wrongAnswers(card).map((name) => `wrong/${name}`),
]

/** A section of the words of a language, from whatever files it stands in. */
export const wordsIn = (language: string, section: string): Words =>
  Object.assign(
    {},
    ...globSync(`words/${language}/*.json`, { cwd: content.path() }).map(
      (file) => (JSON.parse(textOf(file)) as { [section: string]: Words | undefined })[section],
    ),
  ) as Words

/** By key: a sentence, or a table of them. */
interface Words {
  readonly [key: string]: string & { readonly [name: string]: string }
}

/** What there is in content/, as items name it. */
export const there = (): Nameable => ({
  items: new Set(content.items.map(({ id }) => id)),
  cards: new Map(content.cards.map(({ id }) => [id, cardThere(id)])),
  maps: new Map(content.maps.map((id) => [id, mapThere(id)])),
  worlds: new Set(content.worlds),
  sets: new Set(content.sets.map(({ id }) => id)),
  blocks: new Set(Object.keys(definitions)),
  courses: new Set(content.courses.map(({ id }) => id)),
  cages: new Set(content.senseCages.map(({ cage }) => cage.id)),
  questions: new Map(
    [...Map.groupBy(content.questions, ({ module }: Question) => module)].map(([module, all]) => [
      module,
      new Set(all.map(({ id }) => id)),
    ]),
  ),
})

function cardThere(id: string): NameableCard {
  const { playground, starts } = content.card(id)!.card
  const programs = filesOf(id).map((file) => [file, content.program(id, file)!] as const)
  const nets = programs.filter(([, { brains }]) =>
    Object.values(brains).some(({ kind }) => kind === 'network'),
  )
  return {
    ...{ playground, starts: starts.length, files: new Set(filesOf(id)) },
    nets: new Set(nets.map(([file]) => file)),
    blocks: new Map(
      programs.map(([file, program]) => [file, new Set(blocksIn(program).map((block) => block.id))]),
    ),
  }
}

function mapThere(id: string) {
  const { actions: moves } = content.mapFile(id)!.map
  const roads = moves.flatMap((list, from) => list.map(({ to }) => `${from}-${to}`))
  return { stations: moves.length, roads: new Set(roads) }
}
