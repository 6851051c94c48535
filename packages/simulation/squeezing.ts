import { partsWithin } from './geometry/gaps.ts'
import { moveBody } from './geometry/outlines.ts'
import type { Scene } from './scene.ts'
import type { Cm } from './types.ts'

// The physics library gives way when much pushes from two sides (a slab between a robot and a wall): bodies sink into
// each other. Where that would begin, nobody moves for this tick.

/** Bodies may overlap this much. */
const DEEPEST: Cm = 0.3

/** Keeps everybody's place for `undoSqueezing`. */
export function noteBefore({ places, before }: Scene): void {
  for (let body = 0; body < places.length; body++) {
    const { x, y, heading } = places[body]!
    before[body * 3] = x
    before[body * 3 + 1] = y
    before[body * 3 + 2] = heading
  }
}

/** Puts bodies that came too deep into each other, and all that lean on them, back to where they were, at rest. */
export function undoSqueezing(scene: Scene): void {
  const { near, ground } = scene
  const { bodyOf } = ground.outlines
  let squeezed: Set<number> | null = null
  for (let pair = 0; pair < near.count; pair++) {
    const a = near.a[pair]!
    const b = near.b[pair]!
    if (b < 0 || !partsWithin(ground.outlines, a, b, 0 - DEEPEST) || wasDeep(scene, a, b)) continue
    squeezed ??= new Set()
    squeezed.add(bodyOf[a]!).add(bodyOf[b]!)
  }
  if (squeezed) for (const body of leaningOn(squeezed, scene)) putBack(scene, body)
}

/** What was too deep before the tick already must be able to get out. */
function wasDeep(scene: Scene, a: number, b: number): boolean {
  const { outlines } = scene.ground
  const bodies = [outlines.bodyOf[a]!, outlines.bodyOf[b]!]
  for (const body of bodies) {
    const [x, y, heading] = scene.before.subarray(body * 3, body * 3 + 3) as unknown as [Cm, Cm, number]
    moveBody(outlines, body, x, y, heading)
  }
  const was = partsWithin(outlines, a, b, 0 - DEEPEST)
  for (const body of bodies) {
    const { x, y, heading } = scene.places[body]!
    moveBody(outlines, body, x, y, heading)
  }
  return was
}

/** Spreads over bodies that are near each other; a fixed one passes nothing on. */
function leaningOn(squeezed: Set<number>, { near, ground }: Scene): Set<number> {
  const { bodyOf } = ground.outlines
  const isHeld = (body: number) => squeezed.has(body) && ground.movable[body] === 1
  for (let size = 0; size !== squeezed.size;) {
    size = squeezed.size
    for (let pair = 0; pair < near.count; pair++) {
      const a = bodyOf[near.a[pair]!]!
      const b = near.b[pair]! < 0 ? a : bodyOf[near.b[pair]!]!
      if (isHeld(a) || isHeld(b)) squeezed.add(a).add(b)
    }
  }
  return squeezed
}

function putBack({ places, before, ground }: Scene, body: number): void {
  if (ground.movable[body] === 0) return
  const place = places[body]!
  place.x = before[body * 3]!
  place.y = before[body * 3 + 1]!
  place.heading = before[body * 3 + 2]!
  place.vx = place.vy = place.spin = 0
  moveBody(ground.outlines, body, place.x, place.y, place.heading)
}
