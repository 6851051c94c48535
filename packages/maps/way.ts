import { atan2, cos, sin } from '@botgarten/numbers'
import { meetsItself } from './crossing.ts'
import { pointsAlong, segmentsOf } from './path.ts'
import { between, distance, type Point } from './point.ts'
import type { MapFile } from './types.ts'

/** Points of a way lie so many cm apart. */
const STEP = 1
/** Tightest bend that a robot follows: a hair more than 12 cm. */
const TIGHTEST = 12.2

/** A way as the robot drives it: points in cm of its world (origin bottom left, y up), and its turn at the start. */
export interface Way {
  readonly points: readonly Point[]
  /** Degrees, counter-clockwise from east. */
  readonly heading: number
  /** cm. */
  readonly length: number
}

/** Size in cm of the world that a map becomes. Floors of rooms that are drawn beside each other are one place. */
export const worldSizeOf = ({ size, cmPerUnit, grid }: MapFile) => ({
  width: (size.width / (grid?.floors ?? 1)) * cmPerUnit,
  height: size.height * cmPerUnit,
})

/** How fast the follower of the toolbox gets along its line at power 30, in cm a second: measured on all four maps. */
const FOLLOWER = 5.3

/** Seconds that the follower needs for the way over these stations, about. @throws RangeError where a road is missing */
export const driveSeconds = (map: MapFile, stations: readonly number[]): number =>
  wayThrough(map, stations).length / FOLLOWER

/** The middle of a station in cm of the robot's world. */
export const placeOf = (map: MapFile, station: number): Point =>
  inWorld(map, map.stations[station] ?? { x: NaN, y: NaN })

const inWorld = (map: MapFile, { x, y }: Point): Point => ({
  y: (map.size.height - y) * map.cmPerUnit,
  x: (x % (map.size.width / (map.grid?.floors ?? 1))) * map.cmPerUnit,
})

/**
 * The way over these stations, one after the other, as one smooth line: at a station both roads are cut c cm before
 * and behind its middle, c = max(plaza, 12.2 · tan(turn / 2)), and joined by the arc that touches both.
 * @throws RangeError where a road is missing
 */
export function wayThrough(map: MapFile, stations: readonly number[]): Way {
  const roads = stations.slice(1).map((to, index) => roadPoints(map, stations[index]!, to))
  if (roads.length === 0) throw new RangeError('A way has two stations at least.')
  const points = roads.reduce((way, road) => join(way, road, map.plazaCm))
  return { points, heading: headingFrom(points[0]!, points[1]!), length: lengthOf(points) }
}

/** The first station of a way at which the robot would have to turn more sharply than its roads leave room for; null: none. */
function tightTurn(map: MapFile, stations: readonly number[]): number | null {
  const roads = stations.slice(1).map((to, index) => roadPoints(map, stations[index]!, to))
  const cuts = roads.slice(1).map((road, index) => cutAt(turnBetween(roads[index]!, road), map.plazaCm))
  const tight = cuts.findIndex((cut, index) => {
    const [before, after] = [cuts[index - 1] ?? 0, cuts[index + 1] ?? 0]
    return cut + before > lengthOf(roads[index]!) || cut + after > lengthOf(roads[index + 1]!)
  })
  return tight < 0 ? null : stations[tight + 1]!
}

/** Why the robot cannot drive a way: it would have to turn on the spot at this station, or its line crosses itself. */
export type WayFault = { readonly kind: 'turn'; readonly station: number } | { readonly kind: 'crosses' }

/** @returns null where it can */
export function wayFault(map: MapFile, stations: readonly number[]): WayFault | null {
  // Start and goal are one station.
  if (stations.length < 2) return null
  const station = tightTurn(map, stations)
  if (station !== null) return { kind: 'turn', station }
  return meetsItself(wayThrough(map, stations).points) ? { kind: 'crosses' } : null
}

/** A way leg by leg: how far to turn at a station (degrees, to the right above 0; 0 at the start) and how many cm to the next. */
export function legsOf(map: MapFile, stations: readonly number[]) {
  const roads = stations.slice(1).map((to, index) => roadPoints(map, stations[index]!, to))
  return stations.map((station, k) => ({
    station,
    turn: k > 0 && roads[k] ? (-turnBetween(roads[k - 1]!, roads[k]) * 180) / Math.PI : 0,
    length: roads[k] ? lengthOf(roads[k]) : 0,
  }))
}

/** The centre line of a road in cm, about 1 cm from point to point. */
function roadPoints(map: MapFile, from: number, to: number): readonly Point[] {
  const segments = segmentsOf(map.roads[`${from}-${to}`] ?? '')
  if (segments !== null && map.grid) return doorway(placeOf(map, from), placeOf(map, to))
  if (segments === null) throw new RangeError(`No road leads from ${from} to ${to}.`)
  const { cmPerUnit } = map
  const drawn = [segments[0]!.from, ...segments.flatMap((one) => pointsAlong(one, STEP / cmPerUnit))]
  return drawn.map((point) => inWorld(map, point))
}

/** Straight from the middle of a room to that of the next. */
const doorway = (from: Point, to: Point): readonly Point[] => [
  from,
  ...pointsAlong({ from, to, arc: null }, STEP),
]

/** How many cm before and behind the middle of a station a way leaves its roads. */
const cutAt = (turn: number, plaza: number) => Math.max(plaza, TIGHTEST * tangentOf(turn))
const tangentOf = (turn: number) => Math.abs(sin(turn / 2) / cos(turn / 2))

function join(way: readonly Point[], road: readonly Point[], plaza: number): readonly Point[] {
  const turn = turnBetween(way, road)
  const tangent = tangentOf(turn)
  const cut = cutAt(turn, plaza)
  const before = firstPart(way, lengthOf(way) - cut)
  const after = firstPart(road.toReversed(), lengthOf(road) - cut).toReversed()
  return [
    ...before,
    ...arcBetween(before.at(-1)!, after[0]!, turn, tangent < 1e-3 ? 0 : cut / tangent),
    ...after,
  ]
}

/** Radians, −π..π, counter-clockwise positive. Roads are straight next to a station. */
function turnBetween(way: readonly Point[], road: readonly Point[]): number {
  const [a, b] = [way.at(-2)!, way.at(-1)!]
  const [c, d] = [road[0]!, road[1]!]
  const [x, y, u, v] = [b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y]
  return atan2(x * v - y * u, x * u + y * v)
}

/** The points between both ends of an arc; radius 0: straight on. */
function arcBetween(from: Point, to: Point, turn: number, radius: number): readonly Point[] {
  // With y up a sweep is counter-clockwise.
  const arc = radius === 0 ? null : { radius, large: false, sweep: turn > 0 }
  return pointsAlong({ from, to, arc }, STEP).slice(0, -1)
}

/** The first so many cm of a line. */
function firstPart(points: readonly Point[], cm: number): readonly Point[] {
  let left = cm
  for (let index = 1; index < points.length; index++) {
    const [a, b] = [points[index - 1]!, points[index]!]
    const step = distance(a, b)
    if (step >= left) return [...points.slice(0, index), between(a, b, left / step)]
    left -= step
  }
  return points
}

const lengthOf = (points: readonly Point[]): number =>
  points.reduce((sum, point, index) => sum + (index === 0 ? 0 : distance(points[index - 1]!, point)), 0)

const headingFrom = (a: Point, b: Point): number => (atan2(b.y - a.y, b.x - a.x) * 180) / Math.PI
