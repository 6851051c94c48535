import type { Point, Size } from './points.ts'
import { clamp } from './points.ts'

/** Which part of the floor is seen: `x`, `y` (cm, y up) is in the middle of the pane, `scale` is px per cm. */
export interface Camera {
  readonly x: number
  readonly y: number
  readonly scale: number
}

/** A thing the camera should keep in sight: middle and radius in cm. */
export interface Sight extends Point {
  readonly radius: number
}

/** Width in px of the wooden frame around the floor. */
export const frameWidth = 12

// Seconds in which the camera makes up 63 % of the way.
const lag = 0.35
// Cm around the robot that stay in sight.
const elbowRoom = 22
const nearest = 2.6
/** Bo is 21.5 cm wide: 44 px. */
const closeEnough = 2.05
/** So much of the floor is seen at least, in cm, however small the pane is. */
const leastSeen = 95
const farthest = 1
const wholeFloor = 3

/** Where the whole floor is what counts, Bo may be this small, in px per cm. */
const wholeLeast = 0.8

/**
 * Px per cm for a floor (cm) in a pane (px): the whole floor where Bo stays big enough, else so close that `need` (cm),
 * Bo and what is next to it, just fits, unless Bo were less than 44 px wide then. `whole`: all of the floor counts, as a map does.
 */
export function scaleFor(pane: Size, floor: Size, need: Size | 'whole'): number {
  const fit = ({ width, height }: Size, margin: number) =>
    Math.min((pane.width - margin) / width, (pane.height - margin) / height)
  const least = clamp(Math.min(pane.width, pane.height) / leastSeen, farthest, closeEnough)
  const whole = fit(floor, 2 * frameWidth)
  if (need === 'whole') return clamp(whole, wholeLeast, wholeFloor)
  return whole >= closeEnough ? Math.min(whole, wholeFloor) : clamp(fit(need, 0), least, nearest)
}

/** Px per cm beyond which a hand cannot bring the floor nearer. */
export const nearestZoom = 8

/** Px per cm at which the whole floor and its frame fit into the pane. */
export const wholeScale = (pane: Size, floor: Size): number =>
  Math.min(
    (pane.width - 2 * frameWidth) / floor.width,
    (pane.height - 2 * frameWidth) / floor.height,
    nearestZoom,
  )

/** Room in cm for the robot and the thing nearest to it, with elbow room around the robot. */
export function needOf(robot: Point, things: readonly Sight[]): Size {
  const near = nearestTo(robot, things)
  const along = (away: number) => Math.max(2 * elbowRoom, Math.abs(away) + elbowRoom + (near?.radius ?? 0))
  return { width: along((near?.x ?? robot.x) - robot.x), height: along((near?.y ?? robot.y) - robot.y) }
}

/** Px that stay free around what is brought into sight: names, measures and notes stand there. */
const roomAround = 44
/** So near to the edge it still is in sight, in px. */
const seenAround = 40

/**
 * The camera that has all these points in sight: in the middle of them, at this scale where that suffices, else
 * farther away. Null where all of them are in sight already.
 */
export function bringing(points: readonly Point[], now: Camera, pane: Size, floor: Size): Camera | null {
  const inside = ({ x, y }: Point) =>
    x > seenAround && y > seenAround && x < pane.width - seenAround && y < pane.height - seenAround
  if (points.every((point) => inside(toPane(point, now, pane)))) return null
  const ends = (along: readonly number[]) => [Math.min(...along), Math.max(...along)] as const
  const [left, right] = ends(points.map(({ x }) => x))
  const [low, high] = ends(points.map(({ y }) => y))
  const fit = (seen: number, length: number) => Math.max(1, seen - 2 * roomAround) / Math.max(1, length)
  const far = Math.min(now.scale, fit(pane.width, right - left), fit(pane.height, high - low))
  const scale = Math.max(far, Math.min(now.scale, wholeScale(pane, floor)))
  return keepOnFloor({ x: (left + right) / 2, y: (low + high) / 2, scale }, pane, floor)
}

/** Room in cm for several robots with elbow room around them. */
export function needOfAll(robots: readonly Point[]): Size {
  const along = (places: readonly number[]) => Math.max(...places) - Math.min(...places) + 2 * elbowRoom
  return { width: along(robots.map(({ x }) => x)), height: along(robots.map(({ y }) => y)) }
}

/** Never looks further past the edge than the frame is wide; a floor smaller than the pane stands in its middle. */
export function keepOnFloor(camera: Camera, pane: Size, floor: Size): Camera {
  const along = (at: number, seen: number, length: number) => {
    const half = (seen / 2 - frameWidth) / camera.scale
    return 2 * half >= length ? length / 2 : clamp(at, half, length - half)
  }
  return {
    scale: camera.scale,
    x: along(camera.x, pane.width, floor.width),
    y: along(camera.y, pane.height, floor.height),
  }
}

// Cm: so far beyond what can be seen, a thing no longer draws the camera to it.
const longing = 80

/**
 * Where the camera wants to be: so that the robot and the thing nearest to it are both in sight, towards it where it is
 * a little too far away, else on the robot. The robot always keeps its elbow room.
 */
export function aim(robot: Point, things: readonly Sight[], scale: number, pane: Size, floor: Size): Camera {
  const near = nearestTo(robot, things)
  if (!near) return keepOnFloor({ scale, x: robot.x, y: robot.y }, pane, floor)
  const x = leaning(near.x - robot.x, near.radius, pane.width / scale)
  const y = leaning(near.y - robot.y, near.radius, pane.height / scale)
  const share = Math.max(0, 1 - Math.hypot(x.beyond, y.beyond) / longing)
  return keepOnFloor({ scale, x: robot.x + x.lean * share, y: robot.y + y.lean * share }, pane, floor)
}

/** How far to look past the robot along one axis to see a thing `away` from it, and how far beyond that the thing is. */
function leaning(away: number, radius: number, seen: number): { lean: number; beyond: number } {
  const free = Math.max(0, seen / 2 - elbowRoom)
  const middle = (away + Math.sign(away) * (radius - elbowRoom)) / 2
  const lean = Math.abs(away) < elbowRoom ? away / 2 : clamp(middle, -free, free)
  return { lean, beyond: Math.max(0, Math.abs(away - lean) - radius - seen / 2) }
}

function nearestTo(robot: Point, things: readonly Sight[]): Sight | undefined {
  const gap = (thing: Sight) => Math.hypot(thing.x - robot.x, thing.y - robot.y) - thing.radius
  return things.reduce<Sight | undefined>(
    (best, one) => (!best || gap(one) < gap(best) ? one : best),
    undefined,
  )
}

/** One step of following, `seconds` after the last one. Arrives when it is less than a quarter pixel away. */
export function follow(camera: Camera, target: Camera, seconds: number): Camera {
  const share = 1 - Math.exp(-seconds / lag)
  const x = camera.x + (target.x - camera.x) * share
  const y = camera.y + (target.y - camera.y) * share
  const left = Math.max(Math.abs(target.x - x), Math.abs(target.y - y)) * target.scale
  return left < 0.25 ? target : { x, y, scale: target.scale }
}

/** Where the floor's top left corner lies in the pane, in px. */
export const floorCorner = (camera: Camera, pane: Size, floor: Size): Point => ({
  x: pane.width / 2 - camera.x * camera.scale,
  y: pane.height / 2 - (floor.height - camera.y) * camera.scale,
})

/** Cm (y up) to px inside the floor's own box (y down from its top left corner). */
export const onFloor = (point: Point, floor: Size, scale: number): Point => ({
  x: point.x * scale,
  y: (floor.height - point.y) * scale,
})

/** Px in the pane to cm on the floor. */
export function fromPane(at: Point, camera: Camera, pane: Size): Point {
  return {
    x: camera.x + (at.x - pane.width / 2) / camera.scale,
    y: camera.y - (at.y - pane.height / 2) / camera.scale,
  }
}

/** Cm on the floor to px in the pane. */
export const toPane = (point: Point, camera: Camera, pane: Size): Point => ({
  x: pane.width / 2 + (point.x - camera.x) * camera.scale,
  y: pane.height / 2 - (point.y - camera.y) * camera.scale,
})

/** Length in cm of the scale bar: the largest of 10, 20, 50, 100 that is at most 140 px long. */
export const scaleBar = (scale: number): number => [100, 50, 20].find((cm) => cm * scale <= 140) ?? 10
