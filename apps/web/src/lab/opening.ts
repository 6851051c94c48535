import type { LoadedCard } from '#content/cards.ts'
import { allCards, floorAddress, loadCard, loadFreeLab } from '#content/cards.ts'
import { keepsAnything } from '#storage/database.ts'
import { freshId, load } from '#storage/projects.ts'
import { knowOwnMaps } from '@botgarten/blocks'
import { cardProject } from '@botgarten/content/document'
import { parseProject, salvageProject, type Project } from '@botgarten/programs'
import { withWords } from '#words/message.ts'
import { askForPixels, pictureIn } from './floor/pictures.ts'
import { paintFloor, type Floor, type World } from '@botgarten/simulation'

/** A project that is about to be shown. */
export interface Opened {
  readonly id: string
  /** 0 where nothing is kept yet. */
  readonly revision: number
  readonly project: Project
  readonly card: LoadedCard | null
  readonly floor: Floor
  readonly floorAddress: string | null
  /** Does its program hold more than the plain shelf? */
  readonly expert: boolean
  /** Message keys of what went wrong on the way; the lab stands all the same. */
  readonly error: 'brokenHere' | 'partlyHere' | 'floorMissing' | null
  /** What lies on the device and could not be read whole. */
  readonly damaged: { readonly name: string; readonly raw: unknown } | null
  /** Does this device keep anything at all? */
  readonly keeps: boolean
}

/** Brings the blocks that programs need. */
export interface Packs {
  /** @returns whether the project's programs hold more than the plain language */
  loadFor(project: Pick<Project, 'programs' | 'brains'>): Promise<boolean>
  /** The blocks for deeper networks, for maps and groups. */
  loadLearning(): Promise<void>
}

/** What a route of the lab shows: a card, or `free`; null where no card has this name. */
export async function openLab(name: string, projectId: string | null, packs: Packs): Promise<Opened | null> {
  // What the device holds is looked up while the card and its floor travel.
  const stored = load(projectId ?? name)
  const floorOfCard = allCards.find(({ id }) => id === name)?.floor
  if (floorOfCard !== undefined) askForPixels({ asset: floorOfCard })
  const card = name === 'free' ? null : await loadCard(name)
  if (name !== 'free' && !card) return null
  const fresh = card ? cardProject(card.world, card.card, card.start, card.card.id) : await loadFreeLab()
  const kept = readKept(projectId ?? name, name, fresh, await stored)
  const project = kept.project ?? fresh
  const own = name === 'free' ? await ownCardIn(project) : null
  knowOwnMaps(namesOf(project))
  const [floor, expert] = await Promise.all([
    floorOf(project),
    packs.loadFor(project),
    ...(name === 'free' ? [packs.loadLearning()] : []),
  ])
  return {
    id: kept.id,
    revision: kept.revision,
    project,
    card: card ?? own,
    floor: floor ?? paintFloor({ ...project.world, floor: { colour: '#FFFFFF' } }),
    floorAddress: pictureOf(project),
    expert,
    error: kept.error ?? (floor ? null : 'floorMissing'),
    damaged: kept.damaged,
    keeps: kept.revision > 0 || (await keepsAnything()),
  }
}

/** The card that somebody has made of a project; what is still being made is a project like every other. */
async function ownCardIn(project: Project): Promise<LoadedCard | null> {
  const { ownCard } = project
  if (!ownCard || ownCard.draft) return null
  const { loadedFrom } = await withWords(import('#content/own-card.ts'), ['own-card'])
  return loadedFrom({ ...project, ownCard })
}

const namesOf = ({ maps = {} }: Project) =>
  Object.fromEntries(Object.entries(maps).map(([id, { name }]) => [id, name]))

/** The floor of a project that is only to be run, once its blocks are there; a blank one where its picture is missing. */
export async function floorToRun(project: Project, packs: Packs): Promise<Floor> {
  knowOwnMaps(namesOf(project))
  const [floor] = await Promise.all([floorOf(project), packs.loadFor(project)])
  return floor ?? paintFloor({ ...project.world, floor: { colour: '#FFFFFF' } })
}

/**
 * A kept project is read as carefully as a stranger's file. One that is damaged or too much stays where it is, and what of
 * it can be opened becomes a project of its own.
 */
function readKept(id: string, place: string, fresh: Project, kept: Awaited<ReturnType<typeof load>>) {
  if (!kept) return { id, revision: 0, project: null, error: null, damaged: null }
  try {
    const project = parseProject(kept.project)
    return { id, revision: kept.revision, project, error: null, damaged: null }
  } catch (cause) {
    console.warn('A kept project cannot be read.', cause)
    const project = salvageProject(kept.project, fresh)?.project ?? null
    const name = project?.name || id
    return {
      ...{ id: freshId(place), revision: 0 },
      project: project && { ...project, name },
      error: project ? ('partlyHere' as const) : ('brokenHere' as const),
      damaged: { name, raw: kept.project },
    }
  }
}

/** Address of the picture a world lies on; null where it lies on a colour. */
export const floorPictureOf = (world: World, assets: Project['assets']): string | null =>
  pictureOf({ world, assets })

/** Of all pictures the one that lies on a floor: only that is kept. */
export function ownPictureIn(floor: World['floor'], pictures: Project['assets']): Project['assets'] {
  const own = 'asset' in floor ? pictures[floor.asset] : undefined
  return 'asset' in floor && own ? { [floor.asset]: own } : {}
}

const assetOf = ({ world, assets }: Pick<Project, 'world' | 'assets'>) =>
  'asset' in world.floor && Object.hasOwn(assets, world.floor.asset) ? assets[world.floor.asset] : undefined

/** Address of the floor's picture, from the product or from the project itself. */
function pictureOf(project: Pick<Project, 'world' | 'assets'>): string | null {
  const asset = assetOf(project)
  return asset ? `data:image/png;base64,${asset.base64}` : floorAddress(project.world)
}

async function floorOf(project: Project): Promise<Floor | null> {
  const world: World = project.world
  if (!('asset' in world.floor)) return paintFloor(world)
  try {
    const asset = assetOf(project)
    const picture = await pictureIn(world, asset)
    return picture && paintFloor(world, picture)
  } catch (cause) {
    console.warn('The picture of the floor cannot be read.', cause)
    return null
  }
}
