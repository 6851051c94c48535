/** How many stations each map has; the drawings are in content/maps. */
const stations = { MAP_RAILWAY: 6, MAP_FOREST: 10, MAP_CITY: 20, MAP_MARS: 9 } as const

type MapName = keyof typeof stations

export const mapNames = [
  'MAP_MARS',
  'MAP_RAILWAY',
  'MAP_FOREST',
  'MAP_CITY',
] as const satisfies readonly MapName[]

/** Stations of a map by the name in a block's field; 0 for a map that is not there. */
export const stationsOf = (name: string): number =>
  Object.hasOwn(stations, name) ? stations[name as MapName] : 0

/** What the fields of a learner take at most. */
export const mostEpisodes = 100_000
export const mostMoves = 1_000_000
