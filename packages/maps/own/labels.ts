import { paper, type RoadMap } from '@botgarten/programs'
import type { Point } from '../point.ts'
import { lineOf, sampled } from './line.ts'

/** The name of a station on the map: the middle of its text, from the middle of its station. */
export interface StationLabel {
  readonly text: string
  readonly x: number
  readonly y: number
  readonly size: number
}

/** The lab enlarges stations and names up to this factor on a small screen. */
export const LARGEST = 1.5
/** Letters of a name, as far as there is room, and their sizes. */
const lengths = [18, 12, 8]
const sizes = [40, 32]
/** Of the discs of stations, with their edge. */
const RADIUS = 48
/** Below, above, right and left of a station, at its corners, and farther below and above. */
const sides = [[0, 1], [0, -1], [1, 0], [-1, 0], [1, 1], [-1, 1], [1, -1], [-1, -1], [0, 1.8], [0, -1.8]] as const // prettier-ignore

/** A rectangle: its middle, half its width and half its height. */
interface Area extends Point {
  readonly w: number
  readonly h: number
}

const area = (x: number, y: number, w: number, h = w): Area => ({ x, y, w, h })
const meet = (a: Area, b: Area) => Math.abs(a.x - b.x) < a.w + b.w && Math.abs(a.y - b.y) < a.h + b.h

/** The area of a label at a station, with the stations enlarged `times`. */
export const labelArea = (station: Point, { text, x, y, size }: StationLabel, times: number): Area =>
  area(
    station.x + x * times,
    station.y + y * times,
    // Letters of the font are 0.58 wide on average; 0.62 is more than any name took.
    (0.31 * size * [...text].length + 4) * times,
    0.58 * size * times,
  )

/**
 * Places the name of every station where it covers no station, reward, flag or sign and no other name, and as little road as
 * possible. Null: the station has no name, or there is no such place.
 */
export function labelsOf(map: RoadMap): readonly (StationLabel | null)[] {
  if (!map.stations.some(({ name }) => name)) return map.stations.map(() => null)
  const lines = map.roads.map((road) => sampled(lineOf(map, road).there))
  const points = lines.flat().map(({ x, y }) => area(x, y, 0))
  const taken = [1, LARGEST].map((times) => ({ times, areas: marksOf(map, lines, times) }))
  return map.stations.map((station) => {
    const near = points.filter(({ y }) => Math.abs(y - station.y) < 200)
    const free = candidatesOf(station.name ?? '').filter((label) =>
      taken.every(({ times, areas }) => {
        const own = labelArea(station, label, times)
        return isOnPaper(own) && !areas.some((other) => meet(own, other))
      }),
    )
    const covered = free.map((label) => {
      const own = labelArea(station, label, 1)
      return near.filter((point) => meet(own, point)).length
    })
    const best = free[covered.indexOf(Math.min(...covered))]
    if (!best) return null
    for (const { times, areas } of taken) areas.push(labelArea(station, best, times))
    return best
  })
}

const isOnPaper = ({ x, y, w, h }: Area) =>
  Math.min(x - w, y - h, paper.width - x - w, paper.height - y - h) > 4

/** Large letters before small ones, then less of the name. */
function candidatesOf(name: string): readonly StationLabel[] {
  const letters = [...name]
  if (!name) return []
  const texts = lengths.map((most) =>
    letters.length > most ? `${letters.slice(0, most - 1).join('')}…` : name,
  )
  return [...new Set(texts)].flatMap((text) =>
    sizes.flatMap((size) =>
      sides.map(([x, y]) => ({
        ...{ text, size, y: y * (RADIUS + 0.62 * size) },
        x: x * (RADIUS + 12 + 0.31 * size * [...text].length),
      })),
    ),
  )
}

/** Stations with their rewards and flags, signs and rewards of roads: the lab puts both at the middle of any road. */
const marksOf = (
  { stations, start, goals, roads }: RoadMap,
  lines: readonly (readonly Point[])[],
  times: number,
): Area[] => [
  ...stations.flatMap(({ x, y, reward }, station) => [
    area(x, y, RADIUS * times),
    ...(reward ? [area(x - 46, y + 46, 38 * times)] : []),
    ...(station === start ? [area(x - 4, y - 78, 32, 42)] : []),
    ...(goals.includes(station) ? [area(x + 60, y - 78, 38, 42)] : []),
  ]),
  ...roads.flatMap(({ reward }, road) => {
    const line = lines[road]!
    const { x, y } = line[Math.floor(line.length / 2)]!
    return [area(x, y, 46), ...(reward ? [area(x + 52, y + 40, 38)] : [])]
  }),
]
