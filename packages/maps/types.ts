import type { QMap } from '@botgarten/learning/q-learning'

/** A unit of a map's drawing costs this where length counts: in the City the way of fewest sections and the shortest one differ then. */
export const LENGTH_COST = 0.02

/** A map as it stands in its file. Places and lengths are in units of the drawing. */
export interface MapFile {
  readonly id: string
  readonly map: QMap
  readonly stations: readonly MapPlace[]
  /** cm of the robot's world a unit. */
  readonly cmPerUnit: number
  /** Of the drawing: its view box. */
  readonly size: { readonly width: number; readonly height: number }
  /** Centre line of every road by its name, `3-5`: path data of `M`, `L`, `A` and `C`. */
  readonly roads: { readonly [name: string]: string }
  /** A way through a station leaves the road so many cm before its middle, at least. */
  readonly plazaCm: number
  /** Rooms instead of roads; the lines between neighbours are in `roads`. */
  readonly grid?: MapGrid
  /** What the map itself sets; a child may choose others. */
  readonly start?: number
  readonly goal?: number
  readonly goalReward?: number
  readonly stepCost?: number
  /** Charged for every unit of the drawing. */
  readonly lengthCost?: number
}

/** A station; some maps name theirs. */
export interface MapPlace {
  readonly x: number
  readonly y: number
  readonly name?: string
}

/** The rooms of a grid world, by its letters (see `gridMap`). */
export interface MapGrid {
  readonly columns: number
  readonly rows: number
  /** One letter a room, row by row. */
  readonly letters: string
  /** 2: a second floor of rooms is drawn beside the first, for who carries something. Both are one place for the robot. */
  readonly floors: number
  /** By column how far the wind pushes upwards; empty: there is none. */
  readonly wind: readonly number[]
}

/** A broken rule, as a word for `map.problem.<kind>`, and the facts of its sentence. */
export interface MapProblem {
  readonly kind:
    | 'notXml'
    | 'tooLarge'
    | 'tooManyElements'
    | 'tooManyAttributes'
    | 'tooDeep'
    | 'noDrawing'
    | 'unsafe'
    | 'idTwice'
    | 'noStations'
    | 'tooManyStations'
    | 'stationMissing'
    | 'stationPlace'
    | 'pathToNowhere'
    | 'pathToItself'
    | 'pathShape'
    | 'pathGap'
    | 'pathPieces'
    | 'pathLong'
    | 'pathsLong'
    | 'pathEnd'
    | 'transform'
    | 'tooFar'
    | 'strangeId'
    | 'number'
    | 'tooManyRoads'
    | 'gridToDraw'
    | 'grid'
    | 'removed'
  readonly facts: { readonly [name: string]: string | number }
}
