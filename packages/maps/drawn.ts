import { most, type Scene } from '@botgarten/programs'
import { between, distance, type Point } from './point.ts'
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
  across: '#0090C0',
  upDown: '#F7D117',
}

/** Of a door between two rooms, in cm; the bands lie over its middle. */
const DOOR = { width: 26, depth: 5 }
/** A world has room for a hundred areas. */
const MOST_ROOMS = 50

/** A way as the floor of the robot's world, and the robot's place on its start, facing along it. */
export interface DrawnWay {
  /** Its first robot starts on the way. */
  readonly scene: Scene
  readonly points: readonly Point[]
}

/**
 * Draws a way: white on its left, black on its right, the robot's path between them; a red bar across its end, where
 * the robot's sensor is when the robot stands on the goal. Every station of it is a disc; rooms have coloured doors.
 * @throws RangeError where a road of it is missing
 */
export function drawWay(map: MapFile, stations: readonly number[]): DrawnWay {
  const { points, heading } = wayThrough(map, stations)
  const onwards = thinned([...points, beyond(points, BEYOND + BAR.width)], most.points)
  const discs = thinned(stations, most.areas).map((station, index) => ({
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
      areas: [...discs, ...doorsOn(map, stations)],
      lines,
      obstacles: [],
      starts: [{ ...points[0]!, heading }],
    },
    points,
  }
}

/** At most `limit` items of a row, evenly spread, with the first and the last one. */
function thinned<Item>(row: readonly Item[], limit: number): readonly Item[] {
  if (row.length <= limit) return row
  return Array.from({ length: limit }, (_, at) => row[Math.round((at * (row.length - 1)) / (limit - 1))]!)
}

/** The doors of a grid that a way goes through: blue across, yellow up and down. Where wind blows it past a room there is none. */
function doorsOn(map: MapFile, stations: readonly number[]): Scene['areas'] {
  if (!map.grid || stations.length > MOST_ROOMS) return []
  const places = stations.map((station) => placeOf(map, station))
  const side = worldSizeOf(map).width / map.grid.columns
  return places.slice(1).flatMap((to, index) => {
    const from = places[index]!
    const isAcross = Math.abs(from.y - to.y) < 1
    if (distance(from, to) > 1.2 * side || (!isAcross && Math.abs(from.x - to.x) >= 1)) return []
    const [width, height] = isAcross ? [DOOR.depth, DOOR.width] : [DOOR.width, DOOR.depth]
    const door = {
      id: `door-${index}`,
      shape: { kind: 'rectangle' as const, width, height },
      pose: { ...between(from, to, 0.5), heading: 0 },
      colour: isAcross ? colours.across : colours.upDown,
    }
    return [door]
  })
}

/** Was the floor of this world drawn from this map? Its discs lie on stations then. */
export function liesOn(map: MapFile, { size, areas }: Pick<Scene, 'size' | 'areas'>): boolean {
  const whole = worldSizeOf(map)
  const discs = areas.filter(({ id }) => !id.startsWith('door-'))
  if (size.width !== whole.width || size.height !== whole.height || discs.length === 0) return false
  const places = map.stations.map((_, station) => placeOf(map, station))
  return discs.every(({ pose }) => places.some(({ x, y }) => x === pose.x && y === pose.y))
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
