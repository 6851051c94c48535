import type { Work } from './work.ts'

export interface Spot {
  readonly x: number
  readonly y: number
}

export interface Room {
  readonly width: number
  readonly height: number
}

const margin = { left: 46, right: 22, top: 22, bottom: 46 }
/** From the axes to where 0 and 10 lie: half a thing. */
const inset = 34
const PLANE = 10

interface Area {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

export interface Field extends Area {
  /** Along the two axes, 0 to 10, to the screen. */
  x(value: number): number
  y(value: number): number
  /** And back, held on the plane. */
  valueX(x: number): number
  valueY(y: number): number
}

const held = (value: number) => Math.max(0, Math.min(PLANE, value))

export function fieldIn({ width, height }: Room): Field {
  const [left, top] = [margin.left, margin.top]
  const field = {
    width: Math.max(120, width - left - margin.right),
    height: Math.max(120, height - top - margin.bottom),
  }
  const [spanX, spanY] = [field.width - 2 * inset, field.height - 2 * inset]
  return {
    ...{ left, top, ...field },
    x: (value) => left + inset + (value / PLANE) * spanX,
    y: (value) => top + inset + (1 - value / PLANE) * spanY,
    valueX: (x) => held(((x - left - inset) / spanX) * PLANE),
    valueY: (y) => held((1 - (y - top - inset) / spanY) * PLANE),
  }
}

/** What has no place along an axis lies in its middle. */
const along = (row: readonly number[], column: number) => (column < 0 ? PLANE / 2 : (row[column] ?? 0))

export const spotOf = (field: Field, row: readonly number[], [x, y]: Work['axes']): Spot => ({
  x: field.x(along(row, x)),
  y: field.y(along(row, y)),
})

/** Things that lie on each other move apart a little, always the same way: each can be seen and touched, none leaves the area. */
export function apart(spots: readonly Spot[], least: number, area: Area): Spot[] {
  const found: Spot[] = []
  for (const spot of spots) found.push(freeNear(spot, found, least, area))
  return found
}

function freeNear(spot: Spot, taken: readonly Spot[], least: number, area: Area): Spot {
  const { left, top, width, height } = area
  const isInside = ({ x, y }: Spot) => x >= left && x <= left + width && y >= top && y <= top + height
  for (let ring = 0; ring < 12; ring++)
    for (let step = 0; step < Math.max(1, 6 * ring); step++) {
      const [right, up] = around(ring, step)
      const near = { x: spot.x + right * least, y: spot.y + up * least }
      const isFree = ({ x, y }: Spot) => (x - near.x) ** 2 + (y - near.y) ** 2 >= (least * 0.95) ** 2
      if (isInside(near) && taken.every(isFree)) return near
    }
  return spot
}

/** Places on a ring of hexagons: left and right come first. */
function around(ring: number, step: number): readonly [number, number] {
  if (ring === 0) return [0, 0]
  const side = Math.floor(step / ring)
  const [from, to] = [corners[side % 6]!, corners[(side + 1) % 6]!]
  const part = (step % ring) / ring
  return [ring * (from[0] + part * (to[0] - from[0])), ring * (from[1] + part * (to[1] - from[1]))]
}

const high = Math.sqrt(3) / 2
const corners = [
  [1, 0],
  [0.5, high],
  [-0.5, high],
  [-1, 0],
  [-0.5, -high],
  [0.5, -high],
] as const

/** The spot nearest to a finger, if it is near; else null. */
export function under(spots: readonly Spot[], x: number, y: number, reach: number): number | null {
  let best: number | null = null
  let least = reach * reach
  spots.forEach((spot, index) => {
    const away = (spot.x - x) ** 2 + (spot.y - y) ** 2
    if (away <= least) [best, least] = [index, away]
  })
  return best
}

const turn = (a: Spot, b: Spot, c: Spot) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)

function half(spots: readonly Spot[]): Spot[] {
  const found: Spot[] = []
  for (const spot of spots) {
    while (found.length > 1 && turn(found.at(-2)!, found.at(-1)!, spot) <= 0) found.pop()
    found.push(spot)
  }
  return found.slice(0, -1)
}

/** The convex hull (Andrew's monotone chain), counter-clockwise; one or two spots are their own. */
export function hullOf(spots: readonly Spot[]): Spot[] {
  const sorted = spots.toSorted((a, b) => a.x - b.x || a.y - b.y)
  if (sorted.length < 3) return sorted
  return [...half(sorted), ...half(sorted.toReversed())]
}

const ways: { readonly [key: string]: Spot } = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
}

/** How far a key moves a flag, in px; null: the key is not for it. `far`: in large steps. */
export function stepByKey(key: string, far: boolean): Spot | null {
  const way = ways[key]
  const length = far ? 40 : 10
  return way ? { x: way.x * length, y: way.y * length } : null
}
