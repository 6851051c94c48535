import { paper, type MapRoad, type RoadMap } from '@botgarten/programs'
import type { Point } from '../point.ts'
import { lineOf, sampled, type RoadLine } from './line.ts'

/** The name of a station on the map: the middle of its text, from the middle of its station. */
export interface StationLabel {
  readonly text: string
  readonly x: number
  readonly y: number
  readonly size: number
}

/** The lab enlarges stations and names up to this factor on a small screen. */
export const LARGEST = 1.5
const sizes = [40, 32]
/** Letters of a name, as far as there is room. */
const lengths = [18, 12, 8]
/** Of the discs of stations, with their edge. */
const RADIUS = 48
const COIN = 38
const SIGN = 46

interface Box {
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
}

const around = ({ x, y }: Point, width: number, height = width): Box => ({
  ...{ left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 },
})
const meet = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom
const holds = ({ left, right, top, bottom }: Box, { x, y }: Point) =>
  x > left && x < right && y > top && y < bottom

/** The area of a label at a station, with the stations enlarged `times`. */
export function labelArea(station: Point, { text, x, y, size }: StationLabel, times: number): Box {
  // Letters of the font are 0.58 wide on average; 0.62 is more than any name took.
  const [width, height] = [0.62 * size * [...text].length + 8, 1.15 * size]
  return around({ x: station.x + x * times, y: station.y + y * times }, width * times, height * times)
}

/**
 * Places the name of every station where it covers no station, reward, flag or sign and no other name, and as little road as
 * possible. Null: the station has no name, or there is no such place.
 */
export function labelsOf(map: RoadMap): readonly (StationLabel | null)[] {
  const taken = [1, LARGEST].map((times) => ({ times, boxes: [...discsOf(map, times), ...marksOf(map)] }))
  const roads = map.roads.flatMap((road) => pointsOf(map, road))
  return map.stations.map((station) => {
    if (!station.name) return null
    const near = roads.filter(({ x, y }) => Math.abs(x - station.x) < 700 && Math.abs(y - station.y) < 200)
    const free = candidatesOf(station.name).filter((label) =>
      taken.every(({ times, boxes }) => {
        const area = labelArea(station, label, times)
        return isOnPaper(area) && !boxes.some((box) => meet(area, box))
      }),
    )
    const covered = free.map((label) => {
      const area = labelArea(station, label, 1)
      return near.filter((point) => holds(area, point)).length
    })
    const best = free[covered.indexOf(Math.min(...covered))]
    if (!best) return null
    for (const { times, boxes } of taken) boxes.push(labelArea(station, best, times))
    return best
  })
}

const isOnPaper = ({ left, right, top, bottom }: Box) =>
  left > 4 && top > 4 && right < paper.width - 4 && bottom < paper.height - 4

/** Large letters before small ones, then less of the name. */
const candidatesOf = (name: string): readonly StationLabel[] =>
  lengths
    .map((most) => shortened(name, most))
    .flatMap((text, at, all) =>
      all.indexOf(text) === at ? sizes.flatMap((size) => placesFor(text, size)) : [],
    )

function shortened(name: string, most: number): string {
  const letters = [...name]
  return letters.length > most ? `${letters.slice(0, most - 1).join('')}…` : name
}

/** Below, above, left and right, at the corners, and farther below and above. */
function placesFor(text: string, size: number): readonly StationLabel[] {
  const far = RADIUS + 0.62 * size
  const aside = RADIUS + 12 + 0.31 * size * [...text].length
  const places: readonly (readonly [x: number, y: number])[] = [
    [0, far],
    [0, -far],
    [aside, 0],
    [-aside, 0],
    [aside, far],
    [-aside, far],
    [aside, -far],
    [-aside, -far],
    [0, 1.8 * far],
    [0, -1.8 * far],
  ]
  return places.map(([x, y]) => ({ text, x, y, size }))
}

/** Stations with their rewards and flags. */
function discsOf({ stations, start, goals }: RoadMap, times: number): Box[] {
  return stations.flatMap(({ x, y, reward }, station) => [
    around({ x, y }, 2 * RADIUS * times),
    ...(reward ? [around({ x: x - 46, y: y + 46 }, 2 * COIN * times)] : []),
    ...(station === start ? [around({ x: x - 4, y: y - 78 }, 64, 84)] : []),
    ...(goals.includes(station) ? [around({ x: x + 60, y: y - 78 }, 76, 84)] : []),
  ])
}

/** Signs and rewards of roads. The lab puts both at the middle of any road. */
const marksOf = (map: RoadMap): Box[] =>
  map.roads.flatMap((road) => {
    const points = pointsOf(map, road)
    const middle = points[Math.floor(points.length / 2)]!
    return [
      around(middle, 2 * SIGN),
      ...(road.reward ? [around({ x: middle.x + 52, y: middle.y + 40 }, 2 * COIN)] : []),
    ]
  })

const known = new WeakMap<RoadLine, readonly Point[]>()

function pointsOf(map: RoadMap, road: MapRoad): readonly Point[] {
  const line = lineOf(map, road)
  const points = known.get(line) ?? sampled(line.there)
  known.set(line, points)
  return points
}
