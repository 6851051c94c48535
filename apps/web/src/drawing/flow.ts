import type { Point, Size } from './points.ts'

/** A box of a flow diagram: its middle and its size, in px. */
export interface FlowBox extends Point, Size {}

export type FlowSide = 'top' | 'bottom' | 'left' | 'right'

/** The middle of a side of a box. */
export const sideOf = ({ x, y, width, height }: FlowBox, side: FlowSide): Point => ({
  x: x + ({ left: -1, right: 1 }[side as string] ?? 0) * (width / 2),
  y: y + ({ top: -1, bottom: 1 }[side as string] ?? 0) * (height / 2),
})

/** How far before the next box a way turns that comes from above and aside. */
const turn = 13

/**
 * The corners of a way from a side of one box to a side of another, its ends included. `lane`: on which x it goes back
 * beside all boxes.
 */
export function wayBetween(from: Point, to: Point, lane?: number): readonly Point[] {
  if (lane !== undefined) return [from, { x: lane, y: from.y }, { x: lane, y: to.y }, to]
  if (from.x === to.x || from.y === to.y) return [from, to]
  const y = to.y - turn
  return [from, { x: from.x, y }, { x: to.x, y }, to]
}

/** A way as a path with round corners. */
export function roundedPath(corners: readonly Point[], radius = 9): string {
  const [first, ...rest] = corners
  const parts = rest.map((corner, at) => {
    const next = rest[at + 1]
    if (!next) return `L${corner.x} ${corner.y}`
    const before = towards(corner, corners[at]!, radius)
    const after = towards(corner, next, radius)
    return `L${before.x} ${before.y}Q${corner.x} ${corner.y} ${after.x} ${after.y}`
  })
  return `M${first!.x} ${first!.y}${parts.join('')}`
}

function towards(from: Point, to: Point, most: number): Point {
  const far = Math.hypot(to.x - from.x, to.y - from.y)
  const share = Math.min(most, far / 2) / far
  return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share }
}
