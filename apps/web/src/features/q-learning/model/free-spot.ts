import type { Area } from './map-first.ts'

interface Point {
  readonly x: number
  readonly y: number
}

/** Of the left upper corner: 0 at the left or upper edge of the map, 1 at the right or lower one. */
export type Spot = readonly [x: number, y: number]

const spots: readonly Spot[] = [
  ...([[0, 1], [1, 1], [0, 0], [1, 0], [0.5, 1], [0.5, 0], [0, 0.5], [1, 0.5], [0.5, 0.5]] as const), // prettier-ignore
  ...([[0.25, 1], [0.75, 1], [0.25, 0], [0.75, 0]] as const), // prettier-ignore
]

/** How many points a chip of this size covers, those within `near` of it included. */
function covered([x, y]: Spot, chip: Area, map: Area, points: readonly Point[], near: number): number {
  const [left, top] = [x * (map.width - chip.width), y * (map.height - chip.height)]
  return points.filter(
    (point) =>
      point.x > left - near &&
      point.x < left + chip.width + near &&
      point.y > top - near &&
      point.y < top + chip.height + near,
  ).length
}

/** Units of the map from a station up to Bo or the flag above it. */
const above = 80

/**
 * Points that a chip must not cover: the stations, Bo above its start and the flag above the goal. While another map loads, the
 * blocks already name its start and goal: stations that this map does not have are left out.
 */
export const keptFree = (stations: readonly Point[], ends: readonly number[]): readonly Point[] => [
  ...stations,
  ...ends.flatMap((at) => stations[at] ?? []).map(({ x, y }) => ({ x, y: y - above })),
]

/**
 * The place at which a chip covers no station and the fewest points of roads; null if each place covers a station. All in
 * units of the map.
 */
export function freeSpot(
  chip: Area,
  map: Area,
  stations: readonly Point[],
  roads: readonly Point[],
  near: number,
): Spot | null {
  const free = spots.filter((spot) => covered(spot, chip, map, stations, near) === 0)
  const covers = free.map((spot) => covered(spot, chip, map, roads, 0))
  return free[covers.indexOf(Math.min(...covers))] ?? null
}
