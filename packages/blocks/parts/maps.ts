/** The maps that a block offers, as Open Roberta names them: `MAP_CITY` is the map `city`. */
export const mapNames = ['MAP_MARS', 'MAP_RAILWAY', 'MAP_FOREST', 'MAP_CITY'] as const

let stationsOn: (map: string) => number = () => Infinity

/** How many stations a map has, 0 where it is not there: maps are content, which blocks do not know. Until then any station may be there. */
export function knowMaps(stations: (map: string) => number): void {
  stationsOn = stations
}

/** Stations of a map by the name in a block's field. */
export const stationsOf = (name: string): number => stationsOn(name.replace(/^MAP_/, '').toLowerCase())

/** What the fields of a learner take at most. */
export const mostEpisodes = 100_000
export const mostMoves = 1_000_000
