import type { RoadMap, MapRoad } from '@botgarten/programs'
import { paper } from '@botgarten/programs'
import { meetsItself } from '../crossing.ts'
import { pointsAlong, readPath, segmentsOf } from '../path.ts'
import { distance, type Point } from '../point.ts'

/** cm. A road runs straight so far from the middle of its stations, and the robot bends no tighter. */
export const STRAIGHT = 15
export const TIGHTEST = 12
export const SHORTEST = 40

/** Tighter than this no corner is drawn: units. */
const SHARP = 1

/** A road as it is drawn: its corners are as round as its straight parts allow. */
export interface RoadLine {
  /** Path data of `M`, `L` and `A` from its first station to its second, and back. */
  readonly there: string
  readonly back: string
  /** cm. */
  readonly length: number
  /** Radius of each bend, in cm; Infinity where the road goes straight on. */
  readonly radii: readonly number[]
  /** It comes back to itself, where a robot that follows it takes the wrong part. */
  readonly crosses: boolean
}

/** Documents never change, so that a road between the same two stations runs where it ran. */
const known = new WeakMap<MapRoad, { readonly from: Point; readonly to: Point; readonly line: RoadLine }>()

/** Where a road runs. The stations of a document that is being edited are there: the schema sees to it. */
export function lineOf({ stations }: Pick<RoadMap, 'stations'>, road: MapRoad): RoadLine {
  const [from, to] = [stations[road.from]!, stations[road.to]!]
  const before = known.get(road)
  if (before?.from === from && before.to === to) return before.line
  const line = drawn(stations, road)
  known.set(road, { from, to, line })
  return line
}

function drawn(stations: RoadMap['stations'], road: MapRoad): RoadLine {
  const points = [stations[road.from]!, ...road.bends, stations[road.to]!]
  const arcs = points.slice(1, -1).map((_, index) => arcAt(points, index + 1))
  const there = pathOf(points, arcs)
  const turned = arcs.map(({ sweep, ...arc }) => ({ ...arc, sweep: !sweep })).toReversed()
  return {
    there,
    back: pathOf(points.toReversed(), turned),
    length: (readPath(there)?.length ?? 0) * paper.cmPerUnit,
    radii: arcs.map(({ radius }) => radius * paper.cmPerUnit),
    crosses: arcs.length > 0 && meetsItself(sampled(there).map(inCm)),
  }
}

const inCm = ({ x, y }: Point): Point => ({ x: x * paper.cmPerUnit, y: y * paper.cmPerUnit })

/** A road in points about 8 units apart. */
export function sampled(line: string): Point[] {
  const segments = segmentsOf(line) ?? []
  return segments[0] ? [segments[0].from, ...segments.flatMap((one) => pointsAlong(one, 8))] : []
}

interface Arc {
  /** Units; Infinity: straight on. */
  readonly radius: number
  /** From the corner to where the arc begins. */
  readonly cut: number
  readonly sweep: boolean
}

function arcAt(points: readonly Point[], index: number): Arc {
  const [before, corner, after] = points.slice(index - 1, index + 2) as [Point, Point, Point]
  const [a, b] = [distance(before, corner), distance(corner, after)]
  if (a === 0 || b === 0) return { radius: 0, cut: 0, sweep: false }
  const cross =
    ((corner.x - before.x) * (after.y - corner.y) - (corner.y - before.y) * (after.x - corner.x)) / (a * b)
  const dot =
    ((corner.x - before.x) * (after.x - corner.x) + (corner.y - before.y) * (after.y - corner.y)) / (a * b)
  // tan(turn / 2)
  const half = 1 + dot > 1e-9 ? Math.abs(cross) / (1 + dot) : Infinity
  const cut = Math.min(roomOf(points, index - 1, a), roomOf(points, index, b))
  if (half < 1e-4) return { radius: Infinity, cut: 0, sweep: false }
  return { radius: half === Infinity ? 0 : cut / half, cut, sweep: cross > 0 }
}

/** How much of a straight part one of its corners may take: half of it, or all but what a station needs. */
function roomOf(points: readonly Point[], index: number, length: number): number {
  const ends = (index === 0 ? 1 : 0) + (index === points.length - 2 ? 1 : 0)
  if (ends === 0) return length / 2
  return Math.max(0, length - STRAIGHT / paper.cmPerUnit)
}

function pathOf(points: readonly Point[], arcs: readonly Arc[]): string {
  const corners = arcs.map((arc, index) => `L${arcData(points, index, arc) ?? at(points[index + 1]!)}`)
  return `M${at(points[0]!)}${corners.join('')}L${at(points.at(-1)!)}`
}

/** The arc at a bend, as path data that begins with its first point; null: the road has a corner there. */
function arcData(points: readonly Point[], bend: number, { radius, cut, sweep }: Arc): string | null {
  if (radius === Infinity || radius < SHARP) return null
  const [from, to] = besidesCorner(points, bend, cut)
  return `${at(from)}A${short(radius)} ${short(radius)} 0 0 ${sweep ? 1 : 0} ${at(to)}`
}

/** The places so many units before and behind a bend. */
function besidesCorner(points: readonly Point[], bend: number, far: number): readonly [Point, Point] {
  const [before, corner, after] = points.slice(bend, bend + 3) as [Point, Point, Point]
  const [a, b] = [distance(before, corner), distance(corner, after)]
  return [along(corner, before, far / a), along(corner, after, far / b)]
}

/** The piece of a road that is one of its bends, as path data. */
export function bendPiece({ stations }: Pick<RoadMap, 'stations'>, road: MapRoad, bend: number): string {
  const points = [stations[road.from]!, ...road.bends, stations[road.to]!]
  const arc = arcData(points, bend, arcAt(points, bend + 1))
  if (arc !== null) return `M${arc}`
  const [from, to] = besidesCorner(points, bend, STRAIGHT)
  return `M${at(from)}L${at(points[bend + 1]!)}L${at(to)}`
}

const along = (from: Point, to: Point, share: number): Point => ({
  x: from.x + (to.x - from.x) * share,
  y: from.y + (to.y - from.y) * share,
})

const short = (value: number) => Number(value.toFixed(3))
const at = ({ x, y }: Point) => `${short(x)} ${short(y)}`

/** What keeps the robot from driving a road; it can still be learned on. */
export type RoadFault = { readonly road: number } & (
  | { readonly kind: 'tight'; readonly bend: number; /** Radius. */ readonly cm: number }
  /** From station to station. */
  | { readonly kind: 'short'; readonly cm: number }
  | { readonly kind: 'crosses' }
)

/** All roads that the robot could not drive, and why: of each the first reason. */
export function faultsOf(map: Pick<RoadMap, 'stations' | 'roads'>): readonly RoadFault[] {
  return map.roads.flatMap((one, road): RoadFault[] => {
    const { length, radii, crosses } = lineOf(map, one)
    const bend = radii.findIndex((radius) => radius < TIGHTEST)
    if (bend >= 0) return [{ road, kind: 'tight', bend, cm: radii[bend]! }]
    if (length < SHORTEST) return [{ road, kind: 'short', cm: length }]
    return crosses ? [{ road, kind: 'crosses' }] : []
  })
}
