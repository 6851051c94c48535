/**
 * What a child has shown a network, with the project. Columns are neurons by id: one that is added later has gaps in the rows
 * before, one that is removed keeps its column for undo.
 */
export interface Examples {
  readonly version: 1
  /** Ids of input neurons, then of outputs: the columns behind a row's head. */
  readonly inputs: readonly string[]
  readonly outputs: readonly string[]
  readonly drives: readonly Drive[]
  readonly rows: readonly Row[]
}

/** Rows that were recorded in one go. */
export interface Drive {
  readonly id: string
  readonly by: ShownBy
  /** Of the run; 0 without one, and of what a program writes. */
  readonly seed: number
  readonly note?: string
  /** Chosen by hand to be held back for the test, or not; goes before the draw. */
  readonly test?: boolean
}

export type ShownBy = (typeof shownBy)[number]
export const shownBy = ['hand', 'keys', 'pad', 'touch', 'coach', 'program', 'file'] as const

/**
 * [index of the drive, tick, x, y, heading, on, …inputs, …outputs]: two decimals, null for a gap. The pose (cm, degrees) is for a
 * ghost in the world, never an input. `on` 0: set aside.
 */
export type Row = readonly (number | null)[]

/** Numbers of a row before its columns. */
export const headOfRow = 6
export const place = { drive: 0, tick: 1, x: 2, y: 3, heading: 4, on: 5 } as const

/** A network has at most so many rows and drives; a project so many rows. */
export const mostOf = { rows: 5000, drives: 200, projectRows: 20_000 } as const
