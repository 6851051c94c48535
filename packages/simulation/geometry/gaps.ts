import type { Cm } from '../types.ts'
import { bringUpToDate, type Outlines } from './outlines.ts'

// Separating axes: the largest gap along an edge's normal. Never more than the true distance, and below 0 exactly when
// two convex parts overlap; so it is safe to ask "may these touch within …".

/** Of a floor. */
export interface Size {
  readonly width: Cm
  readonly height: Cm
}

/** Beyond this a rough distance will do. */
const FAR: Cm = 5

/** Is the gap between two bodies smaller than `margin`? */
export function bodiesWithin(outlines: Outlines, a: number, b: number, margin: Cm): boolean {
  if (!circlesWithin(outlines, a, b, margin)) return false
  for (let partA = outlines.firstPart[a]!; partA < outlines.firstPart[a + 1]!; partA++) {
    for (let partB = outlines.firstPart[b]!; partB < outlines.firstPart[b + 1]!; partB++) {
      if (partsWithin(outlines, partA, partB, margin)) return true
    }
  }
  return false
}

/** Quick answer by the circles round two bodies: false means surely not. */
function circlesWithin({ x, y, reach }: Outlines, a: number, b: number, margin: Cm): boolean {
  const dx = x[b]! - x[a]!
  const dy = y[b]! - y[a]!
  const far = reach[a]! + reach[b]! + margin
  return dx * dx + dy * dy < far * far
}

/** Is the gap between two parts smaller than `margin`? */
export function partsWithin(outlines: Outlines, a: number, b: number, margin: Cm): boolean {
  bringUpToDate(outlines, outlines.bodyOf[a]!)
  bringUpToDate(outlines, outlines.bodyOf[b]!)
  const roundA = outlines.radius[a]! > 0
  const roundB = outlines.radius[b]! > 0
  if (roundA) return roundB ? discsWithin(outlines, a, b, margin) : discWithin(outlines, b, a, margin)
  if (roundB) return discWithin(outlines, a, b, margin)
  return gapAlongNormals(outlines, a, b, margin) < margin && gapAlongNormals(outlines, b, a, margin) < margin
}

/** The smallest distance of a body to the floor's edges; below 0 when it sticks out. Far from them, at most that. */
export function gapToEdge(outlines: Outlines, body: number, size: Size): Cm {
  const x = outlines.x[body]!
  const y = outlines.y[body]!
  const roughly = Math.min(x, size.width - x, y, size.height - y) - outlines.reach[body]!
  if (roughly > FAR) return roughly
  let gap = Infinity
  for (let side = 0; side < 4; side++) gap = Math.min(gap, gapToSide(outlines, body, side, size))
  return gap
}

/** Distance of a body to one side of the floor: 0 left, 1 right, 2 bottom, 3 top. */
export function gapToSide(outlines: Outlines, body: number, side: number, size: Size): Cm {
  let gap = Infinity
  for (let part = outlines.firstPart[body]!; part < outlines.firstPart[body + 1]!; part++)
    gap = Math.min(gap, partToSide(outlines, part, side, size))
  return gap
}

/** Distance of a part to one side of the floor. */
export function partToSide(outlines: Outlines, part: number, side: number, { width, height }: Size): Cm {
  bringUpToDate(outlines, outlines.bodyOf[part]!)
  const along = side < 2 ? outlines.px : outlines.py
  const far = side < 2 ? width : height
  const end = outlines.firstPoint[part + 1]!
  let gap = Infinity
  for (let point = outlines.firstPoint[part]!; point < end; point++)
    gap = Math.min(gap, side % 2 === 0 ? along[point]! : far - along[point]!)
  return gap - outlines.radius[part]!
}

/** The largest gap along one of a's edge normals; stops at the first that is `enough`. */
function gapAlongNormals({ firstPoint, px, py, nx, ny }: Outlines, a: number, b: number, enough: Cm): Cm {
  const endB = firstPoint[b + 1]!
  let widest = -Infinity
  for (let edge = firstPoint[a]!; edge < firstPoint[a + 1]!; edge++) {
    const normalX = nx[edge]!
    const normalY = ny[edge]!
    let nearest = Infinity
    for (let point = firstPoint[b]!; point < endB; point++)
      nearest = Math.min(nearest, normalX * (px[point]! - px[edge]!) + normalY * (py[point]! - py[edge]!))
    if (nearest > widest) widest = nearest
    if (widest >= enough) return widest
  }
  return widest
}

function discsWithin({ firstPoint, px, py, radius }: Outlines, a: number, b: number, margin: Cm): boolean {
  const dx = px[firstPoint[b]!]! - px[firstPoint[a]!]!
  const dy = py[firstPoint[b]!]! - py[firstPoint[a]!]!
  const far = radius[a]! + radius[b]! + margin
  return dx * dx + dy * dy < far * far
}

/** Disc against polygon: beyond a normal by more than the radius, or farther than it from the nearest corner's side. */
function discWithin(outlines: Outlines, polygon: number, disc: number, margin: Cm): boolean {
  const { firstPoint, px, py, radius } = outlines
  const far = radius[disc]! + margin
  if (gapAlongNormals(outlines, polygon, disc, far) >= far) return false
  const x = px[firstPoint[disc]!]!
  const y = py[firstPoint[disc]!]!
  return distanceToPolygon(outlines, polygon, x, y) < far
}

/** From a point to a polygon, 0 inside. */
function distanceToPolygon(outlines: Outlines, polygon: number, x: Cm, y: Cm): Cm {
  const { firstPoint, px, py, nx, ny } = outlines
  const first = firstPoint[polygon]!
  const end = firstPoint[polygon + 1]!
  let inside = true
  let nearest = Infinity
  for (let edge = first; edge < end; edge++) {
    const next = edge + 1 < end ? edge + 1 : first
    const beyond = nx[edge]! * (x - px[edge]!) + ny[edge]! * (y - py[edge]!)
    if (beyond > 0) inside = false
    nearest = Math.min(nearest, toSegment(px[edge]!, py[edge]!, px[next]!, py[next]!, x, y))
  }
  return inside ? 0 : Math.sqrt(nearest)
}

/** Squared distance of a point from the segment a–b. */
function toSegment(ax: Cm, ay: Cm, bx: Cm, by: Cm, x: Cm, y: Cm): number {
  const alongX = bx - ax
  const alongY = by - ay
  const share = ((x - ax) * alongX + (y - ay) * alongY) / (alongX * alongX + alongY * alongY)
  const held = Math.max(0, Math.min(1, share))
  const dx = x - ax - held * alongX
  const dy = y - ay - held * alongY
  return dx * dx + dy * dy
}
