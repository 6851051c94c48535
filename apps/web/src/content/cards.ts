import type { Project } from '@botgarten/programs'
import type { Card, CardProgram, CardText, Playground, WorldFile } from '@botgarten/materials'

/** Everything of a card that the lab shows and runs. */
export interface LoadedCard {
  readonly card: Card
  readonly world: WorldFile
  readonly start: CardProgram
  readonly text: { readonly [language: string]: CardText }
  /** Address of the picture on its front. */
  readonly picture: string | null
}

type Files<File> = { readonly [path: string]: () => Promise<File> }

/** What pages that do not run a card know of it. */
type CardHead = Pick<Card, 'id' | 'code' | 'group'> & { readonly bed: Playground; readonly starts: number }

const heads = import.meta.glob<CardHead>('../../../../content/cards/*/*/card.json', {
  import: 'default',
  query: '?head',
  eager: true,
})
const cards = import.meta.glob<Card>('../../../../content/cards/*/*/card.json', { import: 'default' })
const starts = import.meta.glob<CardProgram>('../../../../content/cards/*/*/start.json', {
  import: 'default',
})
const texts = import.meta.glob<CardText>('../../../../content/cards/*/*/*.md', {
  import: 'default',
})
const worlds = import.meta.glob<WorldFile>('../../../../content/worlds/*/world.json', {
  import: 'default',
})
const floors = import.meta.glob<string>('../../../../content/worlds/*/floor.png', {
  import: 'default',
  query: '?url',
  eager: true,
})

const pixels = import.meta.glob<string>('../../../../content/worlds/*/floor.png', {
  import: 'default',
  query: '?pixels',
  eager: true,
})

const pictures = import.meta.glob<string>('../../../../content/cards/*/*/picture.svg', {
  import: 'default',
  query: '?url',
  eager: true,
})

/** All cards, in the order of their folders. */
export const allCards: readonly CardHead[] = Object.values(heads)

/** Where a project is shown: its card, or the free lab where this version has no such card. */
export const placeOf = ({ card }: Pick<Project, 'card'>): string =>
  allCards.some(({ id }) => id === card) ? card! : 'free'

/** Picture on the front of a card, null for what is no card. */
export const pictureOf = (id: string): string | null =>
  Object.entries(pictures).find(([path]) => path.endsWith(`-${id}/picture.svg`))?.[1] ?? null

const endingWith = <File>(files: Files<File>, end: string) =>
  Object.entries(files).find(([path]) => path.endsWith(end))?.[1]

/** A world of the content. @throws Error for a name that is not there: a mistake in the content. */
export async function loadWorld(name: string): Promise<WorldFile> {
  const file = endingWith(worlds, `/worlds/${name}/world.json`)
  if (!file) throw new Error(`There is no world "${name}".`)
  return file()
}

/** A card with its world, start program and words; null where no card has this id. */
export async function loadCard(id: string): Promise<LoadedCard | null> {
  const path = Object.entries(heads).find(([, head]) => head.id === id)?.[0]
  if (!path) return null
  const card = await cards[path]!()
  const folder = path.replace(/card\.json$/, '')
  const [world, start, ...languages] = await Promise.all([
    loadWorld(card.world),
    starts[`${folder}start.json`]!(),
    ...Object.entries(texts)
      .filter(([file]) => file.startsWith(folder))
      .map(async ([file, text]) => [file.slice(folder.length, -'.md'.length), await text()] as const),
  ])
  return {
    card,
    world,
    start,
    text: Object.fromEntries(languages),
    picture: pictureOf(id),
  }
}

type OnFloor = Pick<WorldFile, 'floor'>

function addressIn(files: { readonly [file: string]: string }, { floor }: OnFloor): string | null {
  if (!('asset' in floor)) return null
  const path = floor.asset.replace(/^content:/, '/content/')
  return Object.entries(files).find(([file]) => file.endsWith(path))?.[1] ?? null
}

/** Address of the picture of a floor, or null for a floor without one. */
export const floorAddress = (world: OnFloor): string | null => addressIn(floors, world)

/** Address of its pixels, for the robot's sensors. */
export const pixelsAddress = (world: OnFloor): string | null => addressIn(pixels, world)

/** The free lab: a garden, and a first program that already drives. */
export async function loadFreeLab(): Promise<Project> {
  const [world, { default: start }] = await Promise.all([
    loadWorld('garden'),
    import('../../../../content/programs/first-drive.json'),
  ])
  return { botgarten: 1, name: 'free', ...(start as unknown as CardProgram), world, assets: {} }
}
