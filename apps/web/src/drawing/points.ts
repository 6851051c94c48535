export interface Point {
  readonly x: number
  readonly y: number
}

export interface Size {
  readonly width: number
  readonly height: number
}

export const lerp = (from: number, to: number, share: number): number => from + (to - from) * share

/** The point at `share` 0..1 of the way from `a` to `b`. */
export const between = (a: Point, b: Point, share: number): Point => ({
  x: lerp(a.x, b.x, share),
  y: lerp(a.y, b.y, share),
})

export const clamp = (value: number, least: number, most: number): number =>
  Math.min(most, Math.max(least, value))

/** Turned about 0 by degrees clockwise, y down. */
export function turned({ x, y }: Point, degrees: number): Point {
  const turn = (degrees * Math.PI) / 180
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)]
  return { x: x * cos - y * sin, y: x * sin + y * cos }
}

export const distance = (a: Point, b: Point): number => Math.hypot(b.x - a.x, b.y - a.y)

/** Where on the line through `a` and `b` the point nearest to `p` lies: 0 at `a`, 1 at `b`, beyond them outside 0..1. */
export function shareAlong(a: Point, b: Point, p: Point): number {
  const dx = b.x - a.x
  const dy = b.y - a.y
  const square = dx * dx + dy * dy
  return square === 0 ? 0 : ((p.x - a.x) * dx + (p.y - a.y) * dy) / square
}

/** Distance from `p` to the segment `a`..`b`. */
export const distanceToSegment = (a: Point, b: Point, p: Point): number =>
  distance(p, between(a, b, clamp(shareAlong(a, b, p), 0, 1)))

/** Rounded to a tenth of a pixel: shorter attributes, and no change where none can be seen. */
export const tenth = (value: number): number => Math.round(value * 10) / 10

/** `x,y x,y …`, as `points` and paths of straight lines take it. */
export const pointList = (points: readonly Point[]): string =>
  points.map(({ x, y }) => `${tenth(x)},${tenth(y)}`).join(' ')
