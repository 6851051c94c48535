/** How far a point is from a centre, and with it what a centre is: see model.md. */
export type Distance = 'euclidean' | 'manhattan' | 'cosine'

/** Points as rows: `values[point * features + feature]`. Any unit; all finite. */
export interface Points {
  readonly values: Float64Array
  readonly count: number
  readonly features: number
}

/** A sorting in progress as plain data. Groups count from 0. */
export interface KState {
  readonly distance: Distance
  /** By group: its centre, a number a feature. */
  readonly centres: readonly (readonly number[])[]
  /** Where they were when this round began: the first to move must not change where the next one goes. */
  readonly before: readonly (readonly number[])[]
  /** By point: its group; −1: none yet. */
  readonly labels: readonly number[]
  /** What comes next: points find their centres, or centres move. */
  readonly phase: 'assign' | 'move' | 'done'
  /** The next point to assign, or the next centre to move. */
  readonly next: number
  /** Did any point change its group in this round? */
  readonly changed: boolean
  /** Finished rounds. */
  readonly round: number
  /** Inertia after every finished assignment. */
  readonly inertia: readonly number[]
}

/** One operation, opened. */
export type KTrace =
  | {
      readonly kind: 'assign'
      readonly round: number
      readonly point: number
      /** To every centre. */
      readonly distances: readonly number[]
      readonly before: number
      readonly label: number
    }
  | {
      readonly kind: 'move'
      readonly round: number
      readonly centre: number
      readonly from: readonly number[]
      readonly to: readonly number[]
      /** The group was empty: its centre goes to this point, the one farthest from its own centre. */
      readonly takes: number | null
    }

/** The outcome of a whole run. */
export interface Clustering {
  readonly centres: readonly (readonly number[])[]
  readonly labels: readonly number[]
  /** After every assignment; the last one is that of the outcome. */
  readonly inertia: readonly number[]
  readonly iterations: number
}

/** Lloyd's algorithm at full speed: a round is all points finding their centres, and where these would move. */
export interface Rounds {
  /**
   * @returns the inertia of these centres, whether any point has changed its group, and where the centres belong now
   */
  next(centres: Float64Array): {
    readonly inertia: number
    readonly changed: boolean
    readonly centres: Float64Array
  }
  /** By point: its group, after at least one round. */
  labels(): Int32Array
}
