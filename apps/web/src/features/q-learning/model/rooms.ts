import type { QWorld } from '@botgarten/learning/q-learning'
import type { MapFile } from '@botgarten/maps'

export type Side = 'left' | 'down' | 'right' | 'up'

/** The arrow of a side. */
export const arrows: { readonly [side in Side]: string } = { left: '←', down: '↓', right: '→', up: '↑' }

/** Corners of a triangle: a side of the room, and its middle. In halves of a room. */
const corners: { readonly [side in Side]: readonly (readonly [number, number])[] } = {
  left: [[-1, -1], [-1, 1]],
  down: [[-1, 1], [1, 1]],
  right: [[1, 1], [1, -1]],
  up: [[1, -1], [-1, -1]],
} // prettier-ignore
const steps: { readonly [side in Side]: readonly [number, number] } = {
  ...{ left: [-1, 0], down: [0, 1], right: [1, 0], up: [0, -1] },
}

/** What is drawn of an action: a triangle, and where its number stands. */
export interface Triangle {
  readonly action: number
  readonly side: Side
  readonly path: string
  readonly x: number
  readonly y: number
}

export interface Room {
  readonly state: number
  readonly x: number
  readonly y: number
  readonly triangles: readonly Triangle[]
}

/** Side of a room, in units of the drawing. */
export const roomSize = ({ size, grid }: MapFile): number => (grid ? size.height / grid.rows : 0)

/** Which side an action of a grid leads to; null on a map with roads. */
export function sideOf({ names }: QWorld, action: number): Side | null {
  const side = names[action]?.replace(/^\d+-/, '') ?? ''
  return side in arrows ? (side as Side) : null
}

/** A fall from the cliff leads back to the start: such a room is never left by an action. */
export const isShown = ({ grid }: MapFile, state: number): boolean =>
  grid?.letters[state % grid.letters.length] !== 'C'

/** Rooms that can be left, with a triangle for each of their actions. Once a world. */
export function roomsOf(world: QWorld, map: MapFile): readonly Room[] {
  const half = roomSize(map) / 2
  const inner = half - 8
  return map.stations.flatMap(({ x, y }, state) => {
    const [first, end] = [world.first[state]!, world.first[state + 1]!]
    const triangles = Array.from({ length: end - first }, (_, k) => first + k).flatMap((action) => {
      const side = sideOf(world, action)
      if (!side) return []
      const [a, b] = corners[side].map(([dx, dy]) => `${x + dx * inner} ${y + dy * inner}`)
      const [dx, dy] = steps[side]
      const at = { x: x + dx * 0.66 * inner, y: y + dy * 0.7 * inner }
      return [{ action, side, path: `M${a}L${x} ${y}L${b}z`, ...at }]
    })
    return triangles.length > 0 && isShown(map, state) ? [{ state, x, y, triangles }] : []
  })
}

/** The way that a room's arrow shows: one that is worth more than another of the room; null where all are alike. */
export function wayOut({ triangles }: Room, q: ArrayLike<number>, best: number): Triangle | null {
  const found = triangles.find(({ action }) => action === best)
  return found && triangles.some(({ action }) => q[action]! < q[best]!) ? found : null
}

/**
 * How good an action is beside the others, 0..100; null where it was never tried. Where moves cost it is its place among
 * all that were tried: one fall would make all other ways alike.
 */
export function warmth(q: ArrayLike<number>, tries: ArrayLike<number>): readonly (number | null)[] {
  const known = Array.from(tries, (count, action) => (count > 0 ? q[action]! : null))
  const values = known.filter((value) => value !== null)
  const highest = Math.max(1e-9, ...values)
  if (values.every((value) => value >= 0))
    return known.map((value) => (value === null ? null : (100 * value) / highest))
  const order = [...new Set(values)].toSorted((a, b) => a - b)
  const places = new Map(order.map((value, index) => [value, (100 * index) / Math.max(1, order.length - 1)]))
  return known.map((value) => (value === null ? null : places.get(value)!))
}

/** Where an action may lead. */
export interface End {
  readonly to: number
  /** 0..1. */
  readonly odds: number
  /** The reward, and γ times the best value there. */
  readonly brings: number
}

/** Where an action may lead, and what that brings by these values; equal ends as one. */
export function endsOf(world: QWorld, q: ArrayLike<number>, action: number, gamma: number): readonly End[] {
  const { outcome, to: targets, reward, upTo } = world
  const ends = new Map<string, End>()
  for (let end = outcome[action]!; end < outcome[action + 1]!; end++) {
    const to = targets[end]!
    const odds = upTo[end]! - (end === outcome[action] ? 0 : upTo[end - 1]!)
    const name = `${to} ${reward[end]!}`
    const before = ends.get(name)?.odds ?? 0
    ends.set(name, { to, odds: before + odds, brings: reward[end]! + gamma * bestAt(world, q, to) })
  }
  return [...ends.values()]
}

/** The largest value of a place; 0 where an attempt ends. */
function bestAt({ first, terminal }: QWorld, q: ArrayLike<number>, state: number): number {
  const values = Array.from({ length: first[state + 1]! - first[state]! }, (_, k) => q[first[state]! + k]!)
  return terminal[state] === 1 || values.length === 0 ? 0 : Math.max(...values)
}
