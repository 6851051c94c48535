import type { Point } from './points.ts'

/** Where the dotting of a trail has come to: what is left until the next dot, and the last point. */
export interface Dotting {
  readonly last: Point | null
  readonly left: number
}

export const undotted: Dotting = { last: null, left: 0 }

/**
 * Dots every `gap` along a line that grows: gives the new dots for the new points, and where to go on.
 * Dotting a line in pieces gives the same dots as dotting it at once.
 */
export function dotsAlong(
  points: readonly Point[],
  gap: number,
  from: Dotting = undotted,
): { readonly dots: readonly Point[]; readonly dotting: Dotting } {
  const dots: Point[] = []
  let { last, left } = from
  for (const point of points) {
    if (last) left = dotSegment(last, point, gap, left, dots)
    last = point
  }
  return { dots, dotting: { last, left } }
}

function dotSegment(a: Point, b: Point, gap: number, left: number, dots: Point[]): number {
  const length = Math.hypot(b.x - a.x, b.y - a.y)
  let at = left
  for (; at < length; at += gap) {
    const share = at / length
    dots.push({ x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share })
  }
  return at - length
}
