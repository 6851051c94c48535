interface Place {
  readonly x: number
  readonly y: number
}

/** What a map looks like. `photo`: a picture of its own lies under the roads. */
export const dresses = ['meadow', 'town', 'railway', 'mars', 'sea', 'paper', 'photo'] as const
export type Dress = (typeof dresses)[number]

/** What lies on the roads, and opens as they turn out to be good. */
export const covers = ['hedge', 'dirt', 'fog'] as const
export type Cover = (typeof covers)[number]

/** The paper that maps are drawn on, in units of 0.2 cm of the robot's world. */
export const paper = { width: 1600, height: 1000, cmPerUnit: 0.2 } as const

/** At most; a map is refused where it is made and where it is read. */
export const mostOfMap = { maps: 20, stations: 40, roads: 120, bends: 4, name: 60, photo: 600_000 } as const

/** Rooms of a grid, on each side. */
export const mostOfRooms = { side: 12, wind: 2 } as const

/** A map that somebody has made. */
export type MapDocument = RoadMap | RoomMap

/** Stations and roads. Places are in units of its paper, y downwards. */
export interface RoadMap {
  readonly kind: 'roads'
  readonly name: string
  readonly dress: Dress
  readonly cover?: Cover
  /** The picture of the dress `photo`: a JPEG of the whole paper, base64, at most `mostOfMap.photo` letters. */
  readonly photo?: string
  /** Their numbers are their places in this list. */
  readonly stations: readonly MapStation[]
  readonly roads: readonly MapRoad[]
  readonly start: number
  /** One or more. Any of them ends an attempt. */
  readonly goals: readonly number[]
  /** Goals pay, and end nothing. */
  readonly endless?: true
  /** Charged for every move. */
  readonly stepCost?: number
  /** A long road costs more than a short one. */
  readonly lengthCounts?: true
}

/** Rooms in a grid. */
export interface RoomMap {
  readonly kind: 'rooms'
  readonly name: string
  /** One letter a room: S start, G goal (a treasure), F floor, W wall, H trap, I ice (see `gridMap`). Equally long. */
  readonly rows: readonly string[]
  /** By column how far the wind pushes upwards: 0..2. */
  readonly wind?: readonly number[]
}

export interface MapStation extends Place {
  readonly name?: string
  /** Paid on arrival: −100..100. */
  readonly reward?: number
}

/** A road between two stations, over up to four bends; in both directions unless it says otherwise. */
export interface MapRoad {
  readonly from: number
  readonly to: number
  readonly bends: readonly Place[]
  readonly oneWay?: true
  /** A sign stands there: for both directions, or for one, seen from `from`. */
  readonly closed?: 'both' | 'there' | 'back'
  /** Paid each time it is taken, in either direction: −100..100. */
  readonly reward?: number
  /** Probability 0..1 to slide onto one of the other roads. */
  readonly slip?: number
}

const placesIn = (map: MapDocument) => (map.kind === 'rooms' ? map.rows.join('').length : map.stations.length)

/** Stations of a project's own maps, by their ids: what the check of its blocks asks for. */
export const stationsOf = ({
  maps = {},
}: {
  readonly maps?: { readonly [id: string]: MapDocument }
}): { readonly [id: string]: number } =>
  Object.fromEntries(Object.entries(maps).map(([id, map]) => [id, placesIn(map)]))
