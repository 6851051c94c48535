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
    return triangles.length > 0 ? [{ state, x, y, triangles }] : []
  })
}

/**
 * How good an action is beside the others, 0..100, and null where it was never tried. What costs as much as the dearest
 * tenth is 0: one fall would make all other ways alike. Where nothing costs, 0 is what is worth nothing.
 */
export function warmth(q: ArrayLike<number>, tries: ArrayLike<number>): readonly (number | null)[] {
  const known = Array.from(tries, (count, action) => (count > 0 ? q[action]! : null))
  const values = known.filter((value) => value !== null).toSorted((a, b) => a - b)
  const lowest = Math.min(0, values[Math.floor(values.length / 10)] ?? 0)
  const highest = Math.max(values.at(-1) ?? 0, lowest + 1e-9)
  return known.map((value) =>
    value === null ? null : Math.max(0, Math.min(100, (100 * (value - lowest)) / (highest - lowest))),
  )
}
