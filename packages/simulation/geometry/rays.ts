import type { Cm } from '../types.ts'
import type { Outlines } from './outlines.ts'

// Own routines (running.md 6), held to the physics library's ray cast by physics/rays.test.ts. Only surfaces that face the ray count; one that lies up to SKIN behind the start counts
// as touching (0), because a sensor that pushes against a thing may stand a hair inside it.
const SKIN = 1
/** Closes the joint between two edges against rounding. */
const JOINT = 1e-12

/** A start on the floor and a direction of length 1. */
export interface Beam {
  x: Cm
  y: Cm
  dx: number
  dy: number
}

/** Distance along a ray to a part's surface, 0..limit; `limit` if it is not hit before. The part's points are current. */
export function rayToPart(outlines: Outlines, part: number, { x, y, dx, dy }: Beam, limit: Cm): Cm {
  const { firstPoint, px, py, radius } = outlines
  const first = firstPoint[part]!
  const round = radius[part]!
  if (round > 0) return rayToCircle(px[first]! - x, py[first]! - y, round, dx, dy, limit)
  const last = firstPoint[part + 1]! - 1
  let nearest = limit
  let fromX = px[last]! - x
  let fromY = py[last]! - y
  for (let point = first; point <= last; point++) {
    const toX = px[point]! - x
    const toY = py[point]! - y
    nearest = rayToEdge(fromX, fromY, toX - fromX, toY - fromY, dx, dy, nearest)
    fromX = toX
    fromY = toY
  }
  return nearest
}

/** Ray against the edge that starts at (fromX, fromY) from the ray's start and runs (alongX, alongY), body to its left. */
function rayToEdge(fromX: Cm, fromY: Cm, alongX: Cm, alongY: Cm, dx: number, dy: number, limit: Cm): Cm {
  const facing = alongX * dy - alongY * dx
  if (facing <= 0) return limit
  const share = (fromY * dx - fromX * dy) / facing
  if (share < -JOINT || share > 1 + JOINT) return limit
  const distance = (alongX * fromY - alongY * fromX) / facing
  return distance < -SKIN || distance >= limit ? limit : Math.max(0, distance)
}

function rayToCircle(centreX: Cm, centreY: Cm, radius: Cm, dx: number, dy: number, limit: Cm): Cm {
  const along = centreX * dx + centreY * dy
  const aside = centreX * dy - centreY * dx
  const inside = radius * radius - aside * aside
  if (inside < 0) return limit
  const distance = along - Math.sqrt(inside)
  return distance < -SKIN || distance >= limit ? limit : Math.max(0, distance)
}

/** Distance along a ray to the edge of a floor from (0, 0) to (width, height), starting on it. */
export function rayToFloorEdge({ x, y, dx, dy }: Beam, width: Cm, height: Cm): Cm {
  const toX = dx > 0 ? (width - x) / dx : dx < 0 ? (0 - x) / dx : Infinity
  const toY = dy > 0 ? (height - y) / dy : dy < 0 ? (0 - y) / dy : Infinity
  return Math.max(0, Math.min(toX, toY))
}
