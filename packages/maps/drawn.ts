import type { Scene } from '@botgarten/programs'
import { distance, type Point } from './point.ts'
import type { MapFile } from './types.ts'
import { placeOf, wayThrough, worldSizeOf } from './way.ts'

/** Width of each of the two bands in cm; the robot follows the edge between them. */
const BAND = 4
/** So far behind the goal the bar lies that stops the robot: its sensor sits 5 cm before its axle. */
const BEYOND = 5.5
const BAR = { length: 12, width: 3 }
const STATION = 9

const colours = {
  floor: '#EFE6CF',
  white: '#FFFFFF',
  black: '#000000',
  red: '#B30006',
  start: '#23804F',
  station: '#D9C8A2',
}

/** A way as the floor of the robot's world, and the robot's place on its start, facing along it. */
export interface DrawnWay {
  /** Its first robot starts on the way. */
  readonly scene: Scene
  readonly points: readonly Point[]
}

/**
 * Draws a way: white on its left, black on its right, the robot's path between them; a red bar across its end, where
 * the robot's sensor is when the robot stands on the goal. Every station of it is a disc.
 * @throws RangeError where a road of it is missing
 */
export function drawWay(map: MapFile, stations: readonly number[]): DrawnWay {
  const { points, heading } = wayThrough(map, stations)
  const onwards = [...points, beyond(points, BEYOND + BAR.width)]
  const discs = stations.map((station, index) => ({
    id: `station-${index}`,
    shape: { kind: 'circle' as const, radius: STATION },
    pose: { ...placeOf(map, station), heading: 0 },
    colour: index === 0 ? colours.start : colours.station,
  }))
  const band = (id: string, colour: string, aside: number) => ({
    ...{ id, colour, width: BAND, points: besides(onwards, aside) },
  })
  const lines = [
    band('white', colours.white, BAND / 2),
    band('black', colours.black, -BAND / 2),
    { id: 'goal', points: bar(points), width: BAR.width, colour: colours.red },
  ]
  const floor = { colour: colours.floor }
  return {
    scene: {
      size: worldSizeOf(map),
      floor,
      areas: discs,
      lines,
      obstacles: [],
      starts: [{ ...points[0]!, heading }],
    },
    points,
  }
}

/** Was the floor of this world drawn from this map? Its discs lie on stations then. */
export function liesOn(map: MapFile, { size, areas }: Pick<Scene, 'size' | 'areas'>): boolean {
  const whole = worldSizeOf(map)
  if (size.width !== whole.width || size.height !== whole.height || areas.length === 0) return false
  const places = map.stations.map((_, station) => placeOf(map, station))
  return areas.every(({ pose }) => places.some(({ x, y }) => x === pose.x && y === pose.y))
}

/** Unit vector along a line at one of its points. */
function alongAt(points: readonly Point[], index: number): Point {
  const from = points[Math.max(0, index - 1)]!
  const to = points[Math.min(points.length - 1, index + 1)]!
  const length = distance(from, to)
  return { y: (to.y - from.y) / length, x: (to.x - from.x) / length }
}

/** The same line, so many cm to its left. */
const besides = (points: readonly Point[], aside: number): Point[] =>
  points.map((point, index) => {
    const along = alongAt(points, index)
    return { y: point.y + along.x * aside, x: point.x - along.y * aside }
  })

function beyond(points: readonly Point[], cm: number): Point {
  const along = alongAt(points, points.length - 1)
  const end = points.at(-1)!
  return { y: end.y + along.y * cm, x: end.x + along.x * cm }
}

function bar(points: readonly Point[]): Point[] {
  const along = alongAt(points, points.length - 1)
  const middle = beyond(points, BEYOND)
  const half = BAR.length / 2
  return [half, -half].map((aside) => ({ y: middle.y + along.x * aside, x: middle.x - along.y * aside }))
}
