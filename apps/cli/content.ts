import { globSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import {
  readCard,
  readCardText,
  type Card,
  type CardProgram,
  type CardText,
  type WorldFile,
} from '@botgarten/materials'
import { paintFloor, readPng, type Floor, type World } from '@botgarten/simulation'

const content = join(import.meta.dirname, '../../content')

const readJson = (path: string): unknown => JSON.parse(readFileSync(path, 'utf8'))

/** A card's folder and its `card.json`. */
export interface FoundCard {
  readonly folder: string
  readonly card: Card
}

/** All cards in the order of their folders. */
export const allCards = (): FoundCard[] =>
  globSync(join(content, 'cards/*/*/card.json'))
    .sort()
    .map((path) => ({ folder: dirname(path), card: readCard(readJson(path)) }))

/** A card by the name of its folder without the number. */
export const findCard = (id: string): FoundCard | undefined => allCards().find(({ card }) => card.id === id)

export const programOf = (folder: string, file: string): CardProgram =>
  readJson(join(folder, file)) as CardProgram

/** File names of the typical wrong answers, in order: the first is `--wrong 1`. */
export const wrongAnswers = (folder: string): string[] => readdirSync(join(folder, 'wrong')).sort()

export const textOf = (folder: string, language: string): CardText =>
  readCardText(readFileSync(join(folder, `${language}.md`), 'utf8'))

export const worldOf = (card: Card): WorldFile =>
  readJson(join(content, 'worlds', card.world, 'world.json')) as WorldFile

/** The world of the free lab. */
export const freeWorld = (): WorldFile => readJson(join(content, 'worlds/garden/world.json')) as WorldFile

/** The floor of a world whose picture is among the contents, or among a project's assets. */
export function floorOf(
  world: World,
  assets: { readonly [sha256: string]: { readonly base64: string } } = {},
): Floor {
  if (!('asset' in world.floor)) return paintFloor(world)
  const { asset } = world.floor
  // Only names that the product ships: a project file must not read other files of this machine.
  const shipped = /^content:(worlds\/[a-z0-9-]+\/floor\.png)$/.exec(asset)?.[1]
  if (shipped) return paintFloor(world, readPng(readFileSync(join(content, shipped))))
  const kept = Object.hasOwn(assets, asset) ? assets[asset] : undefined
  return paintFloor(world, kept && readPng(Buffer.from(kept.base64, 'base64')))
}
