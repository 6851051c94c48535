import {
  mostOfMap as most,
  paper,
  type Dress,
  type RoadMap,
  type MapRoad,
  type MapStation,
} from '@botgarten/programs'
import type { Point } from '../point.ts'

/** Units between the edge of the paper and a station: the robot has room to stand there. */
export const MARGIN = 80

/** An empty map. */
export const emptyMap = (name: string): RoadMap => ({
  ...{ kind: 'roads', name, dress: 'meadow', stations: [], roads: [], start: 0, goals: [0] },
})

/** On the paper, in whole units. */
export const onPaper = ({ x, y }: Point): Point => ({
  x: Math.round(Math.min(paper.width - MARGIN, Math.max(MARGIN, x))),
  y: Math.round(Math.min(paper.height - MARGIN, Math.max(MARGIN, y))),
})

/** A station more, with the next number; the same map where it is full. The second one is the goal. */
export function addStation(map: RoadMap, at: Point): RoadMap {
  if (map.stations.length >= most.stations) return map
  const stations = [...map.stations, onPaper(at)]
  return { ...map, stations, ...(stations.length === 2 && { goals: [1] }) }
}

export const moveStation = (map: RoadMap, station: number, at: Point): RoadMap =>
  setStation(map, station, onPaper(at))

/** Changes a station; what is `undefined` goes. */
export const setStation = (map: RoadMap, station: number, change: Changed<MapStation>): RoadMap => ({
  ...map,
  stations: map.stations.map((one, index) => (index === station ? merged(one, change) : one)),
})

/** A station goes with its roads; the numbers behind it move up. */
export function removeStation(map: RoadMap, station: number): RoadMap {
  const moved = (other: number) => (other > station ? other - 1 : other)
  const goals = map.goals.filter((goal) => goal !== station).map(moved)
  const stations = map.stations.filter((_, index) => index !== station)
  const start = map.start === station ? 0 : moved(map.start)
  return {
    ...{ ...map, stations, start },
    roads: map.roads
      .filter(({ from, to }) => from !== station && to !== station)
      .map((road) => ({ ...road, from: moved(road.from), to: moved(road.to) })),
    goals: goals.length > 0 ? goals : [otherThan(start, stations.length)],
  }
}

const otherThan = (start: number, count: number) => (count < 2 ? 0 : start === count - 1 ? 0 : count - 1)

/** A straight road more, in both directions; the same map where there is one, or no room for it. */
export function addRoad(map: RoadMap, from: number, to: number): RoadMap {
  const known = map.roads.some((road) => joins(road, from, to))
  if (from === to || known || map.roads.length >= most.roads) return map
  return { ...map, roads: [...map.roads, { from: Math.min(from, to), to: Math.max(from, to), bends: [] }] }
}

const joins = (road: MapRoad, a: number, b: number) =>
  (road.from === a && road.to === b) || (road.from === b && road.to === a)

export const removeRoad = (map: RoadMap, road: number): RoadMap => ({
  ...map,
  roads: map.roads.filter((_, index) => index !== road),
})

/** Changes a road; what is `undefined` goes. */
export const setRoad = (map: RoadMap, road: number, change: Changed<MapRoad>): RoadMap => ({
  ...map,
  roads: map.roads.map((one, index) => (index === road ? merged(one, change) : one)),
})

/** Both ways → one way → the other way → both ways. */
export function turnRoad(map: RoadMap, road: number): RoadMap {
  const one = map.roads[road]!
  if (!one.oneWay) return setRoad(map, road, { oneWay: true })
  const turned = { from: one.to, to: one.from, bends: one.bends.toReversed() }
  // Turned a second time it is as it was at first.
  return one.from > one.to
    ? setRoad(map, road, { ...turned, oneWay: undefined })
    : setRoad(map, road, { ...turned, oneWay: true })
}

/** One bend more, before that of number `index`; the same map where a road has all that it may have. */
export function addBend(map: RoadMap, road: number, index: number, at: Point): RoadMap {
  const { bends } = map.roads[road]!
  if (bends.length >= most.bends) return map
  return setRoad(map, road, { bends: bends.toSpliced(index, 0, onPaper(at)) })
}

export const moveBend = (map: RoadMap, road: number, bend: number, at: Point): RoadMap =>
  setRoad(map, road, { bends: map.roads[road]!.bends.with(bend, onPaper(at)) })

export const removeBend = (map: RoadMap, road: number, bend: number): RoadMap =>
  setRoad(map, road, { bends: map.roads[road]!.bends.toSpliced(bend, 1) })

/** Another look; a photo goes with the look `photo`. */
export function setDress({ photo: _, ...map }: RoadMap, dress: Exclude<Dress, 'photo'>): RoadMap {
  return { ...map, dress }
}

/** Start and goal are never one: where the start becomes a goal they change places. */
export function setStart(map: RoadMap, station: number): RoadMap {
  const goals = map.goals.map((goal) => (goal === station ? map.start : goal))
  return { ...map, start: station, goals: [...new Set(goals)] }
}

/** Makes a station a goal, or none any more: one goal stays. */
export function toggleGoal(map: RoadMap, station: number): RoadMap {
  if (station === map.start) return map
  if (!map.goals.includes(station)) return { ...map, goals: [...map.goals, station] }
  return map.goals.length > 1 ? { ...map, goals: map.goals.filter((goal) => goal !== station) } : map
}

/** A station is the only goal. */
export const setGoal = (map: RoadMap, station: number): RoadMap =>
  station === map.start ? map : { ...map, goals: [station] }

/** A change of some parts; `undefined` takes a part away. */
export type Changed<Thing> = { readonly [Part in keyof Thing]?: Thing[Part] | undefined }

export function merged<Thing extends object>(thing: Thing, change: Changed<Thing>): Thing {
  const all = Object.entries({ ...thing, ...change }).filter(([, value]) => value !== undefined)
  return Object.fromEntries(all) as Thing
}
