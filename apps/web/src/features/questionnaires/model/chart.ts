import { scaleLinear } from 'd3-scale'
import { line, stack, stackOffsetDiverging } from 'd3-shape'

/** A piece of a bar, in shares of the widest bar's half: below 0 is left of the middle. */
export interface Piece {
  /** Which option, from 0. */
  readonly at: number
  readonly count: number
  readonly x: number
  readonly width: number
}

/** Names of what is stacked: the middle option lies half on either side. */
const key = (at: number, middle: number) => (at === middle ? 'right' : String(at))

/** The bars' lengths to the left and to the right of the middle. */
function sides(counts: readonly number[]): readonly [number, number] {
  const middle = (counts.length - 1) / 2
  const sum = (of: (at: number) => boolean) =>
    counts.reduce((total, count, at) => total + (of(at) ? count : at === middle ? count / 2 : 0), 0)
  return [sum((at) => at < middle), sum((at) => at > middle)]
}

/**
 * Bars that are stacked around the middle of the middle option, so that negative ones lie left and positive ones right.
 * @param width in px, of the room for the longest of all bars
 * @returns for each bar its pieces in px from the left, and where the middle is
 */
export function around(all: readonly (readonly number[])[], width: number) {
  const [left, right] = all
    .map(sides)
    .reduce(([a, b], [c, d]) => [Math.max(a, c), Math.max(b, d)], [0, 0] as readonly [number, number])
  const x = scaleLinear([-left, right === 0 && left === 0 ? 1 : right], [0, width])
  return { middle: x(0), bars: all.map((counts) => piecesOf(counts, (value) => x(value))) }
}

function piecesOf(counts: readonly number[], x: (value: number) => number): readonly Piece[] {
  const middle = (counts.length - 1) / 2
  const inward = counts.map((_, at) => at).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle))
  const keys = [...(Number.isInteger(middle) ? ['left'] : []), ...inward.map((at) => key(at, middle))]
  const valueOf = (row: readonly number[], name: string) => {
    if (name === 'left') return -row[middle]! / 2
    if (name === 'right') return row[middle]! / 2
    return Number(name) < middle ? -row[Number(name)]! : row[Number(name)]!
  }
  const layers = stack<readonly number[], string>().keys(keys).value(valueOf).offset(stackOffsetDiverging)([
    counts,
  ])
  const spanOf = (name: string) => layers.find((layer) => layer.key === name)![0]!
  return counts.flatMap((count, at): Piece[] => {
    if (count === 0) return []
    const [from, to] = at === middle ? [spanOf('left')[0], spanOf('right')[1]] : spanOf(key(at, middle))
    return [{ at, count, x: x(from), width: x(to) - x(from) }]
  })
}

/** A bar of shares of all, from the left, in px. */
export function shares(counts: readonly number[], width: number): readonly Piece[] {
  const x = scaleLinear([0, counts.reduce((sum, count) => sum + count, 0) || 1], [0, width])
  let before = 0
  return counts.flatMap((count, at): Piece[] => {
    const from = before
    before += count
    return count === 0 ? [] : [{ at, count, x: x(from), width: x(before) - x(from) }]
  })
}

/** A line of shares from moment to moment, as a path; `room`: a box in px. */
export function slope(
  points: readonly { readonly at: number; readonly share: number }[],
  of: number,
  room: { readonly left: number; readonly right: number; readonly top: number; readonly bottom: number },
) {
  const x = scaleLinear([0, Math.max(1, of - 1)], [room.left, room.right])
  const y = scaleLinear([0, 1], [room.bottom, room.top])
  const places = points.map(({ at, share }) => ({ x: x(at), y: y(share), share }))
  const path =
    line<(typeof places)[number]>(
      (one) => one.x,
      (one) => one.y,
    )(places) ?? ''
  return { places, path }
}

/** Where a mean of 1 to 5 lies on a strip of so many px. */
export const onStrip = (mean: number, width: number): number => scaleLinear([1, 5], [0, width])(mean)
