import type { Project } from '@botgarten/programs'

interface Dot {
  readonly x: number
  readonly y: number
  /** Number of the nearest flag, from 0. */
  readonly group: number
}

type Row = readonly number[]

/** Dots of a picture, at most. */
const most = 200
const rowsIn = (value: unknown): readonly Row[] =>
  Array.isArray(value) && value.every((row) => Array.isArray(row) && row.every(Number.isFinite))
    ? (value as readonly Row[])
    : []

/** The points of a sorting playground, on a plane of 10 × 10 with y downwards. The project is not trusted. */
export function dotsOf({ sorting }: Pick<Project, 'sorting'>): readonly Dot[] {
  const { axes, rows, centres } = { axes: null, ...sorting } as { readonly [part: string]: unknown }
  const [x = 0, y = 1] = Array.isArray(axes) ? (axes as readonly number[]) : []
  const flags = rowsIn(centres)
  return rowsIn(rows)
    .slice(0, most)
    .map((row) => ({ x: row[x] ?? 5, y: 10 - (row[y] ?? 5), group: nearest(row, flags) }))
}

function nearest(row: Row, flags: readonly Row[]): number {
  const away = flags.map((flag) => flag.reduce((sum, value, at) => sum + (value - (row[at] ?? 0)) ** 2, 0))
  return Math.max(0, away.indexOf(Math.min(...away)))
}
