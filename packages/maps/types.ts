import type { QMap } from '@botgarten/learning/q-learning'

/** A map as it stands in its file. Places and lengths are in units of the drawing. */
export interface MapFile {
  readonly id: string
  readonly map: QMap
  readonly stations: readonly { readonly x: number; readonly y: number }[]
  /** cm of the robot's world a unit. */
  readonly cmPerUnit: number
  /** Of the drawing: its view box. */
  readonly size: { readonly width: number; readonly height: number }
  /** Centre line of every road by its name, `3-5`: path data of `M`, `L`, `A` and `C`. Grids have none. */
  readonly roads: { readonly [name: string]: string }
  /** A way through a station leaves the road so many cm before its middle, at least. */
  readonly plazaCm: number
  /** What the map itself sets; a child may choose others. */
  readonly start?: number
  readonly goal?: number
  readonly goalReward?: number
  readonly stepCost?: number
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
    | 'grid'
  readonly facts: { readonly [name: string]: string | number }
}
