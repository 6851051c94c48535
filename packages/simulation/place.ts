import { cos, sin } from '@botgarten/numbers'
import { degreesOf, radiansOf } from './angles.ts'
import { bodiesWithin, gapToSide } from './geometry/gaps.ts'
import { moveBody } from './geometry/outlines.ts'
import { takeUpState, type Scene } from './scene.ts'
import type { Cm, Pose, Radians } from './types.ts'

/** Circles on which a free place is looked for lie this far apart, and so do the places on them, roughly. */
const STEP: Cm = 0.5
/** What is put down by hand keeps this distance. */
const CLEAR = 0.05
/** Beyond this radius circles lie ever farther apart: on a crowded floor nobody waits for a place that is not there. */
const CLOSE_UP = 20
const SPREAD = 1.05

/**
 * Puts a robot or an obstacle down: on the floor, and where it overlaps nothing, as near as can be to the target (rings
 * half a centimetre apart, beyond 20 cm ever farther; in a ring the first place counter-clockwise from the right). A fixed obstacle may overlap other
 * fixed ones. Where there is no free place at all it stays where it was. Unknown ids change nothing.
 */
export function placeByHand(scene: Scene, id: string, target: Pose): Pose {
  const { world, state } = scene
  const robot = world.robots.findIndex((placement) => placement.id === id)
  const obstacle = state.obstacles.findIndex((thing) => thing.id === id)
  const body = robot >= 0 ? robot : world.robots.length + obstacle
  const thing = state.robots[robot] ?? state.obstacles[obstacle]
  if (!thing || !isFinitePose(target)) return target
  const heading = radiansOf(target.heading)
  const free = nearestFree(scene, body, target.x, target.y, heading)
  if (free) Object.assign(thing, free, { heading })
  Object.assign(thing, obstacle >= 0 ? { vx: 0, vy: 0, spin: 0 } : { spin: 0 })
  letGo(scene, id)
  takeUpState(scene)
  return { x: thing.x, y: thing.y, heading: free ? target.heading : degreesOf(thing.heading) }
}

/**
 * Moves what overlaps, or has its middle off the floor, to a free place: fixed things first (only back onto the floor),
 * then movable ones, then robots, each in the world's order.
 */
export function settle(scene: Scene): void {
  const { robots, obstacles } = scene.world
  const movable = obstacles.filter(({ fixed }) => !fixed)
  for (const { id } of obstacles.filter(({ fixed }) => fixed)) if (!isOnFloor(scene, id)) putBack(scene, id)
  // Where one thing finds no place, a bigger one finds none either.
  let tooBig = Infinity
  for (const { id } of [...movable, ...robots]) {
    const body = scene.ids.indexOf(id)
    const reach = scene.ground.outlines.reach[body]!
    if ((isOnFloor(scene, id) && isFree(scene, body, -CLEAR)) || reach >= tooBig) continue
    putBack(scene, id)
    if (!isFree(scene, body, -CLEAR)) tooBig = reach
  }
}

function putBack(scene: Scene, id: string): void {
  const { x, y, heading } = scene.places[scene.ids.indexOf(id)]!
  placeByHand(scene, id, { x, y, heading: degreesOf(heading) })
}

function isOnFloor({ places, ids, ground }: Scene, id: string): boolean {
  const { x, y } = places[ids.indexOf(id)]!
  return x >= 0 && x <= ground.width && y >= 0 && y <= ground.height
}

/** Nobody touches what was taken into the hand, and it touches nobody. */
function letGo({ world, state }: Scene, id: string): void {
  state.robots.forEach((robot, index) => {
    const isOwn = world.robots[index]!.id === id
    robot.touching = isOwn ? [] : robot.touching.filter((touched) => touched !== id)
  })
}

const isFinitePose = ({ x, y, heading }: Pose) => Number.isFinite(x + y + heading)

interface Place {
  readonly x: Cm
  readonly y: Cm
}

function nearestFree(scene: Scene, body: number, wishX: Cm, wishY: Cm, heading: Radians): Place | null {
  const { outlines, width, height } = scene.ground
  const room = roomFor(scene, body, heading)
  const x = within(wishX, room.left, room.right)
  const y = within(wishY, room.bottom, room.top)
  for (let radius = 0; radius < width + height; radius = nextRadius(radius)) {
    const places = radius === 0 ? 1 : Math.min(96, Math.max(8, Math.ceil((2 * Math.PI * radius) / STEP)))
    for (let index = 0; index < places; index++) {
      const angle = (index / places) * 2 * Math.PI
      const place = { x: x + radius * cos(angle), y: y + radius * sin(angle) }
      if (place.x !== within(place.x, room.left, room.right)) continue
      if (place.y !== within(place.y, room.bottom, room.top)) continue
      moveBody(outlines, body, place.x, place.y, heading)
      if (isFree(scene, body, CLEAR)) return place
    }
  }
  return null
}

const nextRadius = (radius: Cm) => (radius < CLOSE_UP ? radius + STEP : radius * SPREAD)

/** Where the origin of a body may be so that all of it is on the floor; a body wider than the floor goes to its middle. */
function roomFor({ ground }: Scene, body: number, heading: Radians) {
  const { outlines, width, height } = ground
  moveBody(outlines, body, 0, 0, heading)
  const point = { width: 0, height: 0 }
  const [left, right, bottom, top] = [0, 1, 2, 3].map(
    (side) => CLEAR - gapToSide(outlines, body, side, point),
  ) as [Cm, Cm, Cm, Cm]
  const isWide = left + right > width
  const isHigh = bottom + top > height
  return {
    left: isWide ? width / 2 : left,
    right: isWide ? width / 2 : width - right,
    bottom: isHigh ? height / 2 : bottom,
    top: isHigh ? height / 2 : height - top,
  }
}

const within = (at: number, low: number, high: number) => Math.max(low, Math.min(high, at))

/** Does a body keep `clear` from all others that it must not overlap, where it stands now? */
function isFree({ ground }: Scene, body: number, clear: Cm): boolean {
  const { outlines, movable } = ground
  for (let other = 0; other < outlines.bodies; other++) {
    if (other === body || movable[body]! + movable[other]! === 0) continue
    if (bodiesWithin(outlines, body, other, clear)) return false
  }
  return true
}
