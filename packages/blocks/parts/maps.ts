import type { FieldLook } from '../types.ts'

/** What blocks have to know of maps: those are content, and a project may hold its own. */
export interface KnownMaps {
  /** Folders of `content/maps`. */
  readonly maps: readonly string[]
  /** How many stations each has. */
  readonly stations: { readonly [map: string]: number }
  /** Where a way begins and ends on each. */
  readonly ends?: { readonly [map: string]: readonly [start: number, goal: number] }
}

let known: KnownMaps | null = null
let ownNames: OwnNames = {}

/** Names of a project's own maps, by their ids. */
interface OwnNames {
  readonly [id: string]: string
}

/** Says which maps the project has that is open: the blocks offer them too. */
export function knowOwnMaps(names: OwnNames): void {
  ownNames = names
}

/** Says which maps there are. Until then any station may be there. */
export function knowMaps(maps: KnownMaps): void {
  known = maps
}

let open: readonly string[] | null = null

/** Leaves only these maps of everybody's to choose from; null: all. */
export function openMaps(maps: readonly string[] | null): void {
  open = maps
}

const countOf = (map: string) => (known === null ? Infinity : (known.stations[map] ?? 0))

/** A map of the project itself stands in a block's field as `own:<id>`. */
const own = /^own:(.+)$/

/** The id of a map of the project by the name in a block's field; null: it is one that everybody has. */
export const ownMapIn = (name: string): string | null => own.exec(name)?.[1] ?? null

/** The map that a block's field names: `own:<id>`, or the folder that Open Roberta calls `MAP_CITY`. */
export const mapIn = (name: string): string =>
  own.test(name) ? name : name.replace(/^MAP_/, '').replaceAll('_', '-').toLowerCase()

/** How a map stands in a block's field. */
export const mapField = (map: string): string =>
  own.test(map) ? map : `MAP_${map.replaceAll('-', '_').toUpperCase()}`

/** Stations of a map by the name in a block's field. `mine`: those of the project's own maps, by their ids. */
export function stationsOf(name: string, mine: { readonly [id: string]: number } = {}): number {
  const id = ownMapIn(name)
  return id === null ? countOf(mapIn(name)) : Object.hasOwn(mine, id) ? mine[id]! : 0
}

/** Where a way begins and ends on the map of a block's field; null for a map of the project, or an unknown one. */
export const mapEnds = (name: string): readonly [start: number, goal: number] | null =>
  known?.ends?.[mapIn(name)] ?? null

/** The maps that everybody has and that are open, small ones first. */
export const knownMaps = (): readonly string[] =>
  (known?.maps ?? []).filter((map) => open?.includes(map) ?? true).toSorted((a, b) => countOf(a) - countOf(b))

/** The field of a block that says on which map: all that are known then, and those of the project. */
export const mapChoice = (preset: string): FieldLook => ({
  name: 'MAP',
  kind: 'choice',
  preset,
  own: 'map',
  get options() {
    const own = Object.entries(ownNames).map(([id, label]) => ({ value: `own:${id}`, words: null, label }))
    const fields = known === null ? [preset] : knownMaps().map(mapField)
    return [...fields.map((value) => ({ value, words: `choice.${value}` })), ...own]
  },
})

/** What the fields of a learner take at most. */
export const mostEpisodes = 100_000
export const mostMoves = 1_000_000
