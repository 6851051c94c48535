import type { Pose } from '@botgarten/simulation'
import { onFloor } from './camera.ts'
import { turned, type Point, type Size } from './points.ts'
import { clockwise, type Outline } from './things.ts'
import type { Scene } from './world.ts'

/** What of a thing can be grabbed, in px about its middle. */
export interface Hit extends Size {
  readonly round: boolean
}

/** What is under a point of the floor's box: a handle, a robot, a thing, the topmost first. */
export type Grabbed =
  { readonly kind: 'turn' } | { readonly kind: 'robot' | 'thing'; readonly id: string; readonly pose: Pose }

/** Bo's own radius in cm, wheels included. */
export const boRadius = 11
/** Px: nothing to grab is smaller than a finger. */
const finger = 44

/** What of a thing can be grabbed. */
export function hitOf({ shape }: { readonly shape: Outline }, scale: number): Hit {
  if (shape.kind === 'circle') return roundHit(shape.radius, scale)
  const { width, height } = shape
  return { width: Math.max(finger, width * scale), height: Math.max(finger, height * scale), round: false }
}

/** What of something round can be grabbed. @param radius in cm */
export function roundHit(radius: number, scale: number): Hit {
  const width = Math.max(finger, 2 * radius * scale)
  return { width, height: width, round: true }
}

/** What a finger takes that comes down at this point of the floor's box, as it was painted; null: the floor. */
export function grabbedAt(scene: Scene, at: Point): Grabbed | null {
  const { chosen, view, things, floor, scale } = scene
  if (chosen && isIn({ width: finger, height: finger, round: true }, at, chosen.handle, 0))
    return { kind: 'turn' }
  const bo = roundHit(boRadius, scale)
  const robot = view.robots.findLast(({ pose }) => isIn(bo, at, onFloor(pose, floor, scale), 0))
  if (robot) return { kind: 'robot', id: robot.id, pose: robot.pose }
  const found = things.findLast(({ pose, thing }) =>
    isIn(hitOf(thing, scale), at, onFloor(pose, floor, scale), clockwise(pose.heading)),
  )
  return found ? { kind: 'thing', id: found.thing.id, pose: found.pose } : null
}

function isIn({ width, height, round }: Hit, at: Point, middle: Point, turn: number): boolean {
  const { x, y } = turned({ x: at.x - middle.x, y: at.y - middle.y }, -turn)
  return round ? Math.hypot(x, y) <= width / 2 : Math.abs(x) <= width / 2 && Math.abs(y) <= height / 2
}
