import { pointsAlong, segmentsOf, type MapFile, type Point } from '@botgarten/maps'

/** A road of the drawing between two stations, both directions in one: from the lower number to the higher. */
export interface Road {
  readonly a: number
  readonly b: number
  /** In units of the drawing, about 8 apart. */
  readonly points: readonly Point[]
  readonly middle: Point
  /** Path data from a to b, and back. */
  readonly there: string
  readonly back: string
}

const STEP = 8

export function roadsOf({ map, roads }: MapFile): readonly Road[] {
  const pairs = map.actions.flatMap((moves, from) =>
    moves
      .flatMap(({ to, outcomes = [] }) => [to, ...outcomes.map((outcome) => outcome.to)])
      .filter((to) => to !== from)
      .map((to) => (from < to ? `${from}-${to}` : `${to}-${from}`)),
  )
  return [...new Set(pairs)].flatMap((pair) => {
    const [a, b] = pair.split('-').map(Number) as [number, number]
    const there = segmentsOf(roads[`${a}-${b}`] ?? '')
    const segments = there ?? segmentsOf(roads[`${b}-${a}`] ?? '')
    if (!segments) return []
    const drawn = [segments[0]!.from, ...segments.flatMap((one) => pointsAlong(one, STEP))]
    const points = there ? drawn : drawn.toReversed()
    const lines = { there: lineOf(points), back: lineOf(points.toReversed()) }
    return [{ a, b, points, middle: alongRoad(points, 0.5), ...lines }]
  })
}

const between = (roads: readonly Road[], from: number, to: number) =>
  roads.find(({ a, b }) => (a === from && b === to) || (a === to && b === from))

/** The road between two stations, in the direction of the ride. */
export function ridden(roads: readonly Road[], from: number, to: number): readonly Point[] {
  const road = between(roads, from, to)
  if (!road) return []
  return road.a === from ? road.points : road.points.toReversed()
}

/** The same as path data. */
export function riddenLine(roads: readonly Road[], from: number, to: number): string {
  const road = between(roads, from, to)
  return (road?.a === from ? road.there : road?.back) ?? ''
}

/** The point at a share 0..1 of a line, by length. */
export function alongRoad(points: readonly Point[], share: number): Point {
  const steps = points
    .slice(1)
    .map((to, index) => Math.hypot(to.x - points[index]!.x, to.y - points[index]!.y))
  let left = steps.reduce((sum, step) => sum + step, 0) * share
  for (const [index, step] of steps.entries()) {
    const [from, to] = [points[index]!, points[index + 1]!]
    if (left <= step && step > 0)
      return { x: from.x + ((to.x - from.x) * left) / step, y: from.y + ((to.y - from.y) * left) / step }
    left -= step
  }
  return points.at(-1) ?? { x: 0, y: 0 }
}

const lineOf = (points: readonly Point[]): string =>
  points.map(({ x, y }, index) => `${index === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`).join('')

/** A small arrow on a road, `share` of its length from its beginning: place and degrees. */
export function arrowOn(points: readonly Point[], share: number): Point & { readonly turn: number } {
  const [at, next] = [alongRoad(points, share), alongRoad(points, share + 0.02)]
  return { ...at, turn: (Math.atan2(next.y - at.y, next.x - at.x) * 180) / Math.PI }
}
