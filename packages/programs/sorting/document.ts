import type { Distance, KState } from '@botgarten/learning/k-means'

/** Where points come from: features of pictured objects, points on the plane, readings of a colour sensor. */
export const sortingSources = ['things', 'points', 'readings'] as const
export type SortingSource = (typeof sortingSources)[number]

/** At most; `column` and `name` are letters of their names. */
export const mostOfSorting = {
  ...{ points: 5000, columns: 8, flags: 6, pages: 20, rounds: 1000 },
  ...{ column: 200, name: 24 },
} as const

/** One data set of the sorting playground: its points, its flags, and how far it is sorted. */
export interface SortingPage {
  readonly source: SortingSource
  /** Id of the data set; '' for points drawn by hand, `table` for those of a file. */
  readonly set: string
  /** Features that count. */
  readonly counting: readonly string[]
  /** Without columns the rows are those of the set. */
  readonly columns: readonly SortingColumn[]
  /** On the plane's scale of 0 to 10. */
  readonly rows: readonly (readonly number[])[]
  /** Columns along the two axes; −1: none. */
  readonly axes?: readonly [x: number, y: number]
  readonly flags: number
  readonly distance: Distance
  readonly centres: readonly (readonly number[])[]
  /** Of groups. */
  readonly names: readonly string[]
  /** Repeated, it leads to the centres, the groups and the inertia of every round. */
  readonly run?: SortingRun
}

export interface SortingColumn {
  readonly feature: string
  readonly part: string
  readonly unit: string
  readonly low: number
  readonly high: number
  readonly scale: number
}

/** Where the flags were placed, and the step that was reached from there. */
export interface SortingRun extends Pick<KState, 'phase' | 'round' | 'next'> {
  readonly start: readonly (readonly number[])[]
}

/**
 * The sorting playground: the displayed data set, and the others. Version 1 has at most one of each other source. The lowest
 * version that can hold it is written, for readers before version 2.
 */
export interface SortingDocument extends SortingPage {
  readonly version: 1 | 2
  /** The last displayed one is the last. */
  readonly pages?: readonly SortingPage[]
}
