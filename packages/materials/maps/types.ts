import type { QMap } from '@botgarten/learning/q-learning'

/** A map as it stands in its file. Places and lengths are in units of the drawing. */
export interface MapFile {
  readonly id: string
  readonly map: QMap
  readonly stations: readonly { readonly x: number; readonly y: number }[]
  /** cm of the robot's world a unit. */
  readonly cmPerUnit: number
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
    | 'pathEnd'
    | 'number'
    | 'grid'
  readonly facts: { readonly [name: string]: string | number }
}
