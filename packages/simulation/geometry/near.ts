import type { Cm } from '../types.ts'
import { bodiesWithin, gapToEdge, partsWithin, partToSide, type Size } from './gaps.ts'
import type { Outlines } from './outlines.ts'

/** Pairs of parts that may touch within a tick. `b` is a part, or −1 − side for a side of the floor (see gaps.ts). */
export interface NearParts {
  count: number
  readonly a: number[]
  readonly b: number[]
  /** By body: 1 if it moves, or may be moved by one that does. */
  readonly active: Uint8Array
  /** Active bodies in the order in which they were found. */
  readonly queue: number[]
}

/** A floor and what stands on it. */
export interface Ground extends Size {
  readonly outlines: Outlines
  /** By body: 1 if it can be moved. */
  readonly movable: Uint8Array
}

export function createNearParts(bodies: number): NearParts {
  return { count: 0, a: [], b: [], active: new Uint8Array(bodies), queue: [] }
}

/**
 * Finds what may touch when the bodies in `moving` go on for a tick and nothing goes farther than half of `margin`:
 * spreads from them over whatever is near. Depends on the places alone, in an order that depends on them alone.
 */
export function findNear(ground: Ground, moving: Uint8Array, margin: Cm, near: NearParts): void {
  const { outlines, movable } = ground
  near.count = 0
  near.active.set(moving)
  let waiting = 0
  for (let body = 0; body < outlines.bodies; body++) if (moving[body] === 1) near.queue[waiting++] = body
  for (let next = 0; next < waiting; next++) {
    const a = near.queue[next]!
    addSides(ground, a, margin, near)
    for (let b = 0; b < outlines.bodies; b++) {
      if (b === a || wasBefore(near, next, b) || !bodiesWithin(outlines, a, b, margin)) continue
      addParts(outlines, a, b, margin, near)
      if (movable[b] === 1 && near.active[b] === 0) {
        near.active[b] = 1
        near.queue[waiting++] = b
      }
    }
  }
}

/** Was the pair with `b` looked at from its side already? */
function wasBefore({ queue, active }: NearParts, next: number, b: number): boolean {
  if (active[b] === 0) return false
  for (let index = 0; index < next; index++) if (queue[index] === b) return true
  return false
}

function addParts(outlines: Outlines, a: number, b: number, margin: Cm, near: NearParts): void {
  const { firstPart } = outlines
  for (let partA = firstPart[a]!; partA < firstPart[a + 1]!; partA++) {
    for (let partB = firstPart[b]!; partB < firstPart[b + 1]!; partB++) {
      if (partsWithin(outlines, partA, partB, margin)) add(near, partA, partB)
    }
  }
}

function addSides(ground: Ground, body: number, margin: Cm, near: NearParts): void {
  const { outlines } = ground
  if (gapToEdge(outlines, body, ground) >= margin) return
  for (let part = outlines.firstPart[body]!; part < outlines.firstPart[body + 1]!; part++) {
    for (let side = 0; side < 4; side++) {
      if (partToSide(outlines, part, side, ground) < margin) add(near, part, -1 - side)
    }
  }
}

function add(near: NearParts, a: number, b: number): void {
  near.a[near.count] = a
  near.b[near.count] = b
  near.count++
}
