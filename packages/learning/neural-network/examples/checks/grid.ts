import { farApart } from './types.ts'

/** Rows that are near to each other lie in cells that touch. */
export interface Grid {
  readonly points: readonly (readonly number[])[]
  readonly side: number
  readonly cells: ReadonlyMap<number, readonly number[]>
  /** The least and the most cell that is in use, by column. */
  readonly bounds: readonly (readonly [least: number, most: number])[]
}

/** Cells are laid over so many columns; the others are compared. */
const columns = 2
/** More cells than any table has on one side. */
const stride = 1 << 20

const keyOf = (a: number, b: number) => a * stride + b

/** Points in cells of a square grid over their first two columns. */
export function gridOf(points: readonly (readonly number[])[], side: number): Grid {
  const cells = new Map<number, number[]>()
  const bounds = Array.from({ length: columns }, (): [number, number] => [Infinity, -Infinity])
  points.forEach((point, at) => {
    const [a, b] = cellOf(point, side)
    const cell = cells.get(keyOf(a, b))
    if (cell) cell.push(at)
    else cells.set(keyOf(a, b), [at])
    ;[a, b].forEach((place, k) => {
      bounds[k]![0] = Math.min(bounds[k]![0], place)
      bounds[k]![1] = Math.max(bounds[k]![1], place)
    })
  })
  return { points, side, cells, bounds }
}

const cellOf = (point: readonly number[], side: number): readonly [number, number] => [
  Math.floor((point[0] ?? 0) / side),
  Math.floor((point[1] ?? 0) / side),
]

/** Visits the points in cells exactly so many cells away from that of a point. Returns whether there can be any farther out. */
function visitRing(
  { side, cells, bounds }: Grid,
  point: readonly number[],
  ring: number,
  visit: (at: number) => void,
): boolean {
  const [a, b] = cellOf(point, side)
  for (let x = a - ring; x <= a + ring; x++) {
    const step = Math.abs(x - a) === ring || ring === 0 ? 1 : 2 * ring
    for (let y = b - ring; y <= b + ring; y += step) for (const at of cells.get(keyOf(x, y)) ?? []) visit(at)
  }
  return bounds.some(([least, most], k) => {
    const place = k === 0 ? a : b
    return place - ring > least || place + ring < most
  })
}

/** Visits the points that are at most one cell away. */
export function visitNear(grid: Grid, point: readonly number[], visit: (at: number) => void): void {
  visitRing(grid, point, 0, visit)
  visitRing(grid, point, 1, visit)
}

/**
 * The nearest others of a point, by the largest difference of any column; of equally near ones the first in the table.
 */
export function nearestOthers(grid: Grid, self: number, count: number): readonly number[] {
  const point = grid.points[self]!
  const found: { readonly at: number; readonly off: number }[] = []
  const take = (at: number) => {
    if (at === self) return
    const off = farApart(point, grid.points[at]!)
    const last = found[count - 1]
    if (last && (off > last.off || (off === last.off && at > last.at))) return
    const place = found.findIndex((one) => one.off > off || (one.off === off && one.at > at))
    found.splice(place < 0 ? found.length : place, 0, { at, off })
    if (found.length > count) found.pop()
  }
  for (let ring = 0; ; ring++) {
    const goesOn = visitRing(grid, point, ring, take)
    // What lies farther out is at least so many whole cells away.
    if (!goesOn || (found.length === count && found[count - 1]!.off < ring * grid.side)) break
  }
  return found.map(({ at }) => at)
}
