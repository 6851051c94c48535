import type { Dress } from '@botgarten/programs'
import { distance, type Point } from '../point.ts'
import { strokesOf, type Stroke } from './dress.ts'
import { ink, round } from './layers.ts'
import { sampled } from './line.ts'

/** Units of the upper road before and behind the middle of a crossing that lie on the bridge. */
const HALF = 46
/** Nearer to the end of a road than this two roads meet at a station and do not cross. */
const STATION = 60

/** A piece of road that leads over another one. */
export interface Bridge {
  /** Index of the road that is above: the later one. */
  readonly upper: number
  readonly lower: number
  /** Path data. */
  readonly line: string
}

/** All bridges of roads by their lines. */
export function bridgesOf(lines: readonly string[]): readonly Bridge[] {
  const roads = lines.map((line) => sampled(line))
  return crossingsOf(roads).map(({ upper, lower, at }) => {
    const near = roads[upper]!.filter((point) => distance(point, at) < HALF)
    const line = near.map(({ x, y }, index) => `${index === 0 ? 'M' : 'L'}${round(x)} ${round(y)}`).join('')
    return { upper, lower, line }
  })
}

/** A bridge has rails on both sides of the road. */
export function bridgeStrokes(dress: Dress): readonly Stroke[] {
  const strokes = strokesOf(dress)
  const { width } = strokes[0]!
  return [{ colour: ink, width: width + 18 }, { colour: '#E3B36F', width: width + 8 }, ...strokes]
}

interface Crossing {
  readonly upper: number
  readonly lower: number
  readonly at: Point
}

/** Where roads cross, and which of them leads over the other: the later one. Ends that meet at a station do not cross. */
function crossingsOf(roads: readonly (readonly Point[])[]): readonly Crossing[] {
  const boxes = roads.map(boxOf)
  return roads.flatMap((road, upper) =>
    roads.slice(0, upper).flatMap((other, lower) => {
      if (!overlap(boxes[upper]!, boxes[lower]!)) return []
      const ends = [road[0]!, road.at(-1)!, other[0]!, other.at(-1)!]
      const clear = (at: Point) => ends.every((end) => distance(end, at) > STATION)
      return meetings(road, other, boxes[lower]!)
        .filter(clear)
        .map((at) => ({ upper, lower, at }))
    }),
  )
}

/** Where two lines meet. @param box around the second one */
function meetings(one: readonly Point[], other: readonly Point[], box: Box): Point[] {
  const found: Point[] = []
  for (let i = 1; i < one.length; i++) {
    if (!overlap(boxOf([one[i - 1]!, one[i]!]), box)) continue
    for (let k = 1; k < other.length; k++) {
      const at = crossing(one[i - 1]!, one[i]!, other[k - 1]!, other[k]!)
      if (at) found.push(at)
    }
  }
  return found
}

type Box = readonly [left: number, top: number, right: number, bottom: number]

function boxOf(points: readonly Point[]): Box {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity]
  for (const { x, y } of points) {
    left = Math.min(left, x)
    top = Math.min(top, y)
    right = Math.max(right, x)
    bottom = Math.max(bottom, y)
  }
  return [left, top, right, bottom]
}

const overlap = (a: Box, b: Box) => a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3]

function crossing(a: Point, b: Point, c: Point, d: Point): Point | null {
  const [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y]
  const area = ux * vy - uy * vx
  if (area === 0) return null
  const s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / area
  const t = ((c.x - a.x) * uy - (c.y - a.y) * ux) / area
  return s >= 0 && s < 1 && t >= 0 && t < 1 ? { x: a.x + s * ux, y: a.y + s * uy } : null
}
