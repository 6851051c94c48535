import maps from 'content:maps'
import { knowMaps, mapField, type Block } from '@botgarten/blocks'
import type { MapProblem } from '@botgarten/maps'
import { emptyMap, endsOf, openMap, ownId } from '@botgarten/maps/own'
import { stationsOf, versionOf, type MapDocument, type Program, type Project } from '@botgarten/programs'
import type { ProjectAutosave } from '#lab/autosave.svelte.ts'
import { newProject } from '#content/new-project.ts'
import { freshId, list, open, save } from '#storage/projects.ts'
import { photoOfDrawing } from './photo.ts'

/** A map of a project that is about to be drawn on. */
export interface OpenedDrawing {
  readonly id: string
  readonly revision: number
  readonly project: Project
  readonly mapId: string
}

/** The maps of this device, the last changed first. */
export async function ownMaps(): Promise<readonly { id: string; mapId: string; map: MapDocument }[]> {
  const { projects } = await list()
  return projects.flatMap(({ id, project }) =>
    Object.entries(project.maps ?? {}).map(([mapId, map]) => ({ id, mapId, map })),
  )
}

/** Null where this device has no such project, or it has no such map. Without a map's name a new one begins. */
export async function openMapOf(
  id: string,
  mapId: string | null,
  name: string,
): Promise<OpenedDrawing | null> {
  const found = await open(id)
  if (!found) return null
  const { project, revision } = found
  if (mapId !== null) return project.maps?.[mapId] ? { id, revision, project, mapId } : null
  const fresh = freeId(project)
  return { id, revision, project: withMap(project, fresh, emptyMap(name)), mapId: fresh }
}

/** A new project that learns on this map. Returns the query of its page; null where this device keeps nothing. */
export async function begin(map: MapDocument): Promise<string | null> {
  const id = freshId('map')
  const project = learningOn(withMap(await newProject(map.name, 'railway'), 'map', map), 'map')
  const saved = await save(id, project, 0)
  return saved.kind === 'saved' ? `p=${encodeURIComponent(id)}&m=map` : null
}

/** A new project that learns on one of the given maps. Null if this device saves nothing. */
export async function learnOnGiven(
  map: string,
  name: string,
): Promise<{ readonly id: string; readonly project: Project } | null> {
  const id = freshId('map')
  const [start, goal] = maps.ends[map]!
  const fields = { MAP: mapField(map), START: String(start), FINISH: String(goal) }
  const tries = String(Math.max(100, 20 * maps.stations[map]!))
  const project = learningWith(await newProject(name, 'railway'), fields, tries)
  const saved = await save(id, project, 0)
  return saved.kind === 'saved' ? { id, project } : null
}

/** Maps that everybody has and that can be drawn on. */
export async function startFrom(id: string, name: string): Promise<MapDocument | null> {
  const text = await maps.map(id)
  return text === null ? null : openMap(text, name).map
}

/** What an opened drawing has become. */
export type ReadDrawing =
  | {
      readonly map: MapDocument
      readonly warnings: readonly MapProblem[]
      /** Its picture could not be taken along. */
      readonly pictureLost: boolean
    }
  | { readonly map: null; readonly problems: readonly MapProblem[] }

/** A drawing of a child's own, or of a friend; what is drawn beside its stations and roads lies under them as a photo. */
export async function openDrawing(text: string, name: string): Promise<ReadDrawing> {
  const opened = openMap(text, name)
  if (opened.map === null) return opened
  const { map, warnings, picture } = opened
  if (picture === null) return { map, warnings, pictureLost: false }
  const read = await photoOfDrawing(picture)
  if (!('photo' in read)) return { map, warnings, pictureLost: true }
  const drawn: MapDocument = map.kind === 'roads' ? { ...map, dress: 'photo', photo: read.photo } : map
  return { map: drawn, warnings, pictureLost: false }
}

function freeId({ maps = {} }: Project): string {
  for (let k = 1; ; k++) {
    const id = k === 1 ? 'map' : `map-${k}`
    if (!Object.hasOwn(maps, id)) return id
  }
}

export function withMap(project: Project, id: string, map: MapDocument): Project {
  const all = { ...project.maps, [id]: map }
  return { ...project, maps: all, botgarten: versionOf({ ...project, maps: all }) }
}

const mapBlock = 'ai_q_learning_states_and_actions_map'
const triesBlock = 'ai_q_apply_learning_rule'

/** The project's programs learn on this map from now on, from its start to its first goal. */
export function learningOn(project: Project, id: string): Project {
  const map = project.maps![id]!
  const { start, goals } = map.kind === 'rooms' ? endsOf(map) : map
  const fields = { MAP: ownId(id), START: String(start), FINISH: String(goals[0]) }
  const places = stationsOf({ maps: { [id]: map } })[id]!
  return learningWith(project, fields, String(Math.max(100, 20 * places)))
}

/** The project with these fields in its map blocks and this number of tries; closed roads and rewards are left out. */
function learningWith(project: Project, fields: { readonly [name: string]: string }, tries: string): Project {
  const changed = (block: Block): Block => {
    if (block.type === mapBlock) {
      const { OBSTACLE: _, ...values } = block.values ?? {}
      return { ...block, fields: { ...block.fields, ...fields, REWARDS: '' }, values }
    }
    const statements = block.statements && {
      statements: mapped(block.statements, (rows) => rows.map(changed)),
    }
    const enough = block.type === triesBlock && { fields: { ...block.fields, EPISODES: tries } }
    return { ...block, ...statements, ...enough }
  }
  const inProgram = (program: Program): Program => ({
    ...program,
    stacks: program.stacks.map((stack) => ({ ...stack, blocks: stack.blocks.map(changed) })),
  })
  return { ...project, programs: mapped(project.programs, inProgram) }
}

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))

knowMaps(maps)

/** What the bar and the paper have to know of a map that is made, of whichever kind. */
export interface Drawing {
  readonly id: string
  readonly mapId: string
  readonly settled: MapDocument
  readonly project: Project
  readonly autosave: ProjectAutosave
  rename(name: string): void
  learnHere(): Promise<boolean>
}
