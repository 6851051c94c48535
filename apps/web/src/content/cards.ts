import catalogue from 'content:cards'
import worlds from 'content:worlds'
import type { WorldFile } from '@botgarten/content'
import type { LoadedCard } from '@botgarten/content/catalogue'
import type { Project } from '@botgarten/programs'

export type { LoadedCard } from '@botgarten/content/catalogue'

/** All cards, in the order of their folders. */
export const allCards = catalogue.cards

/** A card with its world, start program and words; null where no card has this id. */
export const loadCard = catalogue.card

/** The sentence that says what a card is about, by its id and language. */
export const loadGoals = catalogue.goals

/** Picture on the front of a card, null for what is no card. */
export const pictureOf = catalogue.pictureOfCard

export const { floorAddress, pixelsAddress } = worlds

/** The id of a card that somebody has made; no card of the house is called so. */
export const ownCardId = 'own'

/** Id of a card of the house; null for one that somebody has made, and where there is none. */
export const houseIdOf = (loaded: LoadedCard | null): string | null =>
  loaded && loaded.card.id !== ownCardId ? loaded.card.id : null

/** Where a project is shown: its playground, its card, or the free lab where this version has no such card. */
export const placeOf = ({ card, playground }: Pick<Project, 'card' | 'playground'>): string =>
  playground ?? (allCards.some(({ id }) => id === card) ? card! : 'free')

/** A world of the content. @throws Error for a name that is not there: a mistake in the content */
export async function loadWorld(name: string): Promise<WorldFile> {
  const world = await worlds.world(name)
  if (!world) throw new Error(`There is no world "${name}".`)
  return world
}

/** The free lab as a project: its world, and a first program that already drives. */
export async function loadFreeLab(): Promise<Project> {
  const { world, start } = await catalogue.freeLab()
  return { botgarten: 1, name: 'free', ...start, world, assets: {} }
}

/** Every world of the content, in the order of their folders. */
export const allWorlds = (): Promise<readonly { readonly id: string; readonly world: WorldFile }[]> =>
  Promise.all(worlds.worlds.map(async (id) => ({ id, world: (await worlds.world(id))! })))
