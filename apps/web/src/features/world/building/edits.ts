import type { Area, Line, Obstacle, Pose, Shape, World } from '@botgarten/simulation'
import type { Point } from '#drawing/points.ts'
import { fullTurn } from '#drawing/things.ts'

/** Something in a world that can be built with. */
export type Item =
  | { readonly kind: 'obstacles'; readonly thing: Obstacle }
  | { readonly kind: 'areas'; readonly thing: Area }
  | { readonly kind: 'lines'; readonly thing: Line }
export type Kind = Item['kind']

/** No side of anything is shorter or longer (cm). */
const shortest = 1
const longest = 1000

const kinds: readonly Kind[] = ['obstacles', 'areas', 'lines']
const listOf = (world: World, kind: Kind) => world[kind] as readonly Item['thing'][]

export function itemOf(world: World, id: string | null): Item | null {
  for (const kind of kinds) {
    const thing = listOf(world, kind).find((one) => one.id === id)
    if (thing) return { kind, thing } as Item
  }
  return null
}

/** The world with this item in the place of the one of its name, or as its newest. */
export function withItem(world: World, { kind, thing }: Item): World {
  const list = listOf(world, kind)
  const known = list.some(({ id }) => id === thing.id)
  const next = known ? list.map((one) => (one.id === thing.id ? thing : one)) : [...list, thing]
  return { ...world, [kind]: next }
}

export const without = (world: World, { kind, thing }: Item): World => ({
  ...world,
  [kind]: listOf(world, kind).filter(({ id }) => id !== thing.id),
})

/** One further up (1) or down (−1) among its like: later ones lie over earlier ones. */
export function moved(world: World, { kind, thing }: Item, by: 1 | -1): World {
  const list = [...listOf(world, kind)]
  const at = list.findIndex(({ id }) => id === thing.id)
  const other = list[at + by]
  if (at < 0 || !other) return world
  list[at + by] = list[at]!
  list[at] = other
  return { ...world, [kind]: list }
}

/** A name that nothing in the world has. */
export function freshId(world: World, kind: Kind): string {
  const ids = new Set([...kinds.flatMap((one) => listOf(world, one)), ...world.robots].map(({ id }) => id))
  for (let count = 1; ; count++) if (!ids.has(`${kind}${count}`)) return `${kind}${count}`
}

/** Where an item is; a line is where the middle of its box is, and looks east. */
export function poseOf(item: Item): Pose {
  if (item.kind !== 'lines') return item.thing.pose
  const { left, right, bottom, top } = boxOf(item.thing.points)
  return { x: (left + right) / 2, y: (bottom + top) / 2, heading: 0 }
}

export function boxOf(points: readonly Point[]) {
  const xs = points.map(({ x }) => x)
  const ys = points.map(({ y }) => y)
  return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) }
}

/** The item at another place; a line is moved and turned about its middle. */
export function put(item: Item, pose: Pose): Item {
  if (item.kind === 'obstacles') return { ...item, thing: { ...item.thing, pose } }
  if (item.kind === 'areas') return { ...item, thing: { ...item.thing, pose } }
  const from = poseOf(item)
  const turn = (pose.heading * Math.PI) / 180
  const points = item.thing.points.map(({ x, y }) => ({
    x: tenth(pose.x + (x - from.x) * Math.cos(turn) - (y - from.y) * Math.sin(turn)),
    y: tenth(pose.y + (x - from.x) * Math.sin(turn) + (y - from.y) * Math.cos(turn)),
  }))
  return { ...item, thing: { ...item.thing, points } }
}

export function withShape(item: Item, shape: Shape): Item {
  if (item.kind === 'obstacles') return { ...item, thing: { ...item.thing, shape } }
  return item.kind === 'areas' ? { ...item, thing: { ...item.thing, shape } } : item
}

/** In another colour. A thing that looks like a tree or a crate becomes a plain one: else nobody would see it. */
export function withColour(item: Item, colour: string): Item {
  if (item.kind === 'areas') return { ...item, thing: { ...item.thing, colour } }
  if (item.kind === 'lines') return { ...item, thing: { ...item.thing, colour } }
  const { look: _, ...plain } = item.thing
  return { ...item, thing: { ...plain, colour } }
}

/** The shape with its right lower corner (of a circle: its rim) at a point of its own frame, about the same middle. */
export function stretched(shape: Shape, { x, y }: Point): Shape {
  if (shape.kind === 'circle') return { ...shape, radius: side(Math.hypot(x, y)) }
  return sized(shape, 2 * Math.abs(x), 2 * Math.abs(y))
}

/** The shape with another width and height; a triangle keeps its form. */
export function sized(shape: Shape, width: number, height: number): Shape {
  if (shape.kind === 'circle') return { ...shape, radius: side(width / 2) }
  const next = { ...shape, width: side(width), height: side(height) }
  if (next.kind !== 'triangle' || next.tip === undefined || shape.kind !== 'triangle') return next
  return { ...next, tip: (next.tip * next.width) / shape.width }
}

const side = (cm: number) => Math.min(longest, Math.max(shortest, Math.round(cm * 2) / 2))

/** The corner that stretches a shape, in its own frame. */
export function cornerOf(shape: Shape): Point {
  if (shape.kind === 'circle') return { x: shape.radius * Math.SQRT1_2, y: 0 - shape.radius * Math.SQRT1_2 }
  return { x: shape.width / 2, y: 0 - shape.height / 2 }
}

/** A point of the floor in the frame of something that stands at `pose`, and back. */
export function toOwn({ x, y, heading }: Pose, at: Point): Point {
  return turned({ x: at.x - x, y: at.y - y }, 0 - heading)
}

export function toFloor({ x, y, heading }: Pose, own: Point): Point {
  const { x: right, y: up } = turned(own, heading)
  return { x: x + right, y: y + up }
}

function turned({ x, y }: Point, degrees: number): Point {
  const turn = (degrees * Math.PI) / 180
  return { x: x * Math.cos(turn) - y * Math.sin(turn), y: x * Math.sin(turn) + y * Math.cos(turn) }
}

const tenth = (value: number) => Math.round(value * 10) / 10

/** How thick a wall is, in cm. */
const wallWidth = 6

/** A wall from point to point, as a long thin thing that stands fast. */
export function wallBetween(id: string, from: Point, to: Point): Obstacle {
  const length = Math.hypot(to.x - from.x, to.y - from.y)
  const heading = (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI
  return {
    id,
    // Walls that meet at a point meet without a gap.
    shape: { kind: 'rectangle', width: tenth(length + wallWidth), height: wallWidth },
    pose: { x: tenth((from.x + to.x) / 2), y: tenth((from.y + to.y) / 2), heading: tenth(fullTurn(heading)) },
    fixed: true,
    colour: '#D98A63',
    look: 'wall',
  }
}

/** Stands fast instead of giving way, or the other way round. */
export const withFixed = (item: Item): Item =>
  item.kind === 'obstacles' ? { ...item, thing: { ...item.thing, fixed: !item.thing.fixed } } : item

export const withWidth = (item: Item, width: number): Item =>
  item.kind === 'lines' ? { ...item, thing: { ...item.thing, width } } : item
