import {
  addBend,
  addRoad,
  addStation,
  moveBend,
  moveStation,
  sampled,
  setRoad,
  type Reach,
} from '@botgarten/maps/own'
import type { RoadMap, MapRoad } from '@botgarten/programs'
import type { Designer } from './designer.svelte.ts'

export interface At {
  readonly x: number
  readonly y: number
}

/** What a press is on. */
export type Target =
  | { readonly kind: 'station'; readonly index: number }
  | { readonly kind: 'road'; readonly index: number }
  | { readonly kind: 'bend'; readonly road: number; readonly bend: number }
  | { readonly kind: 'paper' }

/** A pull that goes on: what it does at every move, and when it ends on something. */
export interface Pull {
  move(at: At): void
  end(at: At, on: Target): void
  /** A road that is being pulled begins at this station. */
  readonly from?: number
}

/** So far a hand has to go before a press is a pull, in units of the paper. */
export const SLOP = 14

/** What is there within `reach` of a place, in units: bends of the chosen road before stations, and these before roads. */
export function targetAt({ map, lines, chosen, tool }: Designer, { x, y }: At, reach: number): Target {
  const isNear = (one: At, share = 1) => Math.hypot(one.x - x, one.y - y) <= reach * share
  if (chosen?.kind === 'road' && tool !== 'sign') {
    const bend = map.roads[chosen.index]!.bends.findIndex((one) => isNear(one, 0.8))
    if (bend >= 0) return { kind: 'bend', road: chosen.index, bend }
  }
  const station = map.stations.findLastIndex((one) => isNear(one))
  if (station >= 0) return { kind: 'station', index: station }
  const road = lines.findLastIndex(({ there }) => sampled(there).some((one) => isNear(one, 0.75)))
  return road >= 0 ? { kind: 'road', index: road } : { kind: 'paper' }
}

/** What a hand begins where it presses; null: the press alone does it. */
export function pullFrom(designer: Designer, target: Target, begin: At): Pull | null {
  if (target.kind === 'station') {
    designer.chosen = target
    return designer.tool === 'road' ? roadPull(designer, target.index) : stationPull(designer, target.index)
  }
  if (target.kind === 'bend') {
    designer.chosen = { kind: 'road', index: target.road }
    return bendPull(designer, target.road, target.bend)
  }
  if (target.kind === 'road') return newBendPull(designer, target.index, begin)
  return null
}

function stationPull(designer: Designer, station: number): Pull {
  const { map } = designer
  return { move: (at) => designer.pull(moveStation(map, station, at)), end: () => designer.drop() }
}

const roadPull = (designer: Designer, from: number): Pull => ({
  ...{ from, move: () => {} },
  end(_, on) {
    if (on.kind === 'station' && on.index !== from) join(designer, from, on.index)
  },
})

/** A road between two stations: a new one, or the one that is there; it is opened beside the map. */
export function join(designer: Designer, from: number, to: number): void {
  const next = addRoad(designer.map, from, to)
  const index = next.roads.findIndex((road) => joins(road, from, to))
  designer.change(next)
  if (index >= 0) designer.chosen = { kind: 'road', index }
}

const joins = (road: MapRoad, a: number, b: number) =>
  (road.from === a && road.to === b) || (road.from === b && road.to === a)

function bendPull(designer: Designer, road: number, bend: number): Pull {
  const { map } = designer
  return { move: (at) => designer.pull(moveBend(map, road, bend, at)), end: () => designer.drop() }
}

/** Pulled at its middle a road gets one bend more, where the hand has it. */
function newBendPull(designer: Designer, road: number, begin: At): Pull {
  const { map } = designer
  designer.chosen = { kind: 'road', index: road }
  const bent = addBend(map, road, partOf(map, road, begin), begin)
  const bend = partOf(map, road, begin)
  if (bent === map) return { move: () => {}, end: () => {} }
  return { move: (at) => designer.pull(moveBend(bent, road, bend, at)), end: () => designer.drop() }
}

/** Between which of its corners a point of a road lies: the index of a bend that is put in there. */
function partOf({ stations, roads }: RoadMap, index: number, { x, y }: At): number {
  const { from, to, bends } = roads[index]!
  const corners = [stations[from]!, ...bends, stations[to]!]
  const gaps = corners.slice(1).map((b, k) => {
    const a = corners[k]!
    const length = (b.x - a.x) ** 2 + (b.y - a.y) ** 2 || 1
    const share = Math.max(0, Math.min(1, ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / length))
    return Math.hypot(x - a.x - share * (b.x - a.x), y - a.y - share * (b.y - a.y))
  })
  return gaps.indexOf(Math.min(...gaps))
}

const signs = [undefined, 'both', 'there', 'back'] as const

/** A press without a pull: what the tool makes of it. */
export function tap(designer: Designer, target: Target, at: At): void {
  const { tool, map } = designer
  if (target.kind === 'paper') {
    designer.chosen = null
    if (tool !== 'station') return
    const next = addStation(map, at)
    designer.change(next)
    if (next !== map) designer.chosen = { kind: 'station', index: next.stations.length - 1 }
    return
  }
  if (target.kind === 'bend') return
  designer.chosen = target
  if (target.kind === 'road' && tool === 'sign') turnSign(designer, target.index)
}

/** No sign → both ways closed → one way → the other way. */
function turnSign(designer: Designer, road: number): void {
  const { closed, oneWay } = designer.map.roads[road]!
  const offered = oneWay ? signs.slice(0, 2) : signs
  const next = offered[(offered.indexOf(closed) + 1) % offered.length]
  designer.change(setRoad(designer.map, road, { closed: next }))
}

/** Is there anything to learn: two stations, and a way? */
export const canLearn = (map: RoadMap, { way }: Reach): boolean =>
  map.stations.length > 1 && !map.goals.includes(map.start) && way !== null
