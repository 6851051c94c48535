import { cos, sin } from '@botgarten/numbers'
import type { Cm, Radians } from '../types.ts'
import type { Part } from './parts.ts'

// No object literal here starts with `x:` of anything but a number: V8 would give all literals of that shape, the
// physics library's vectors among them, fields that allocate on every write (measured: four times slower).

/**
 * Where all bodies are, in flat arrays that rays and overlap tests run over. A body has parts (convex pieces), a part
 * has points: the corners of a polygon, counter-clockwise, or the centre of a circle.
 */
export interface Outlines {
  readonly bodies: number
  /** By body: place of its origin and heading; how far it reaches from there; are its points up to date? */
  readonly x: Float64Array
  readonly y: Float64Array
  readonly cos: Float64Array
  readonly sin: Float64Array
  readonly reach: Float64Array
  readonly current: Uint8Array
  /** By body: its first part. The next body's is its end. */
  readonly firstPart: Int32Array
  /** By part: its first point, its body, and its radius (0: a polygon). */
  readonly firstPoint: Int32Array
  readonly bodyOf: Int32Array
  readonly radius: Float64Array
  /** By point, in the body's frame and on the floor; the normal is that of the edge to the next corner, outwards. */
  readonly ownX: Float64Array
  readonly ownY: Float64Array
  readonly ownNormalX: Float64Array
  readonly ownNormalY: Float64Array
  readonly px: Float64Array
  readonly py: Float64Array
  readonly nx: Float64Array
  readonly ny: Float64Array
}

export function createOutlines(bodies: readonly (readonly Part[])[]): Outlines {
  const parts = bodies.flat()
  const points = parts.reduce((sum, part) => sum + cornersOf(part).length, 0)
  const floats = (length: number) => new Float64Array(length)
  const outlines: Outlines = {
    bodies: bodies.length,
    x: floats(bodies.length),
    y: floats(bodies.length),
    cos: floats(bodies.length).fill(1),
    sin: floats(bodies.length),
    reach: Float64Array.from(bodies, (own) => Math.max(0, ...own.map(reachOf))),
    current: new Uint8Array(bodies.length),
    firstPart: starts(bodies.map((own) => own.length)),
    firstPoint: starts(parts.map((part) => cornersOf(part).length)),
    bodyOf: Int32Array.from(bodies.flatMap((own, body) => own.map(() => body))),
    radius: Float64Array.from(parts, (part) => (part.kind === 'circle' ? part.radius : 0)),
    ownX: floats(points),
    ownY: floats(points),
    ownNormalX: floats(points),
    ownNormalY: floats(points),
    px: floats(points),
    py: floats(points),
    nx: floats(points),
    ny: floats(points),
  }
  parts.forEach((part, index) => writeOwn(outlines, part, outlines.firstPoint[index]!))
  return outlines
}

/** Puts a body somewhere. Its points follow when somebody asks (`bringUpToDate`). */
export function moveBody(outlines: Outlines, body: number, x: Cm, y: Cm, heading: Radians): void {
  outlines.x[body] = x
  outlines.y[body] = y
  outlines.cos[body] = cos(heading)
  outlines.sin[body] = sin(heading)
  outlines.current[body] = 0
}

export function bringUpToDate(outlines: Outlines, body: number): void {
  if (outlines.current[body] === 1) return
  const { ownX, ownY, ownNormalX, ownNormalY, px, py, nx, ny } = outlines
  const x = outlines.x[body]!
  const y = outlines.y[body]!
  const c = outlines.cos[body]!
  const s = outlines.sin[body]!
  const end = outlines.firstPoint[outlines.firstPart[body + 1]!]!
  for (let point = outlines.firstPoint[outlines.firstPart[body]!]!; point < end; point++) {
    px[point] = x + c * ownX[point]! - s * ownY[point]!
    py[point] = y + s * ownX[point]! + c * ownY[point]!
    nx[point] = c * ownNormalX[point]! - s * ownNormalY[point]!
    ny[point] = s * ownNormalX[point]! + c * ownNormalY[point]!
  }
  outlines.current[body] = 1
}

function writeOwn(outlines: Outlines, part: Part, first: number): void {
  const { ownX, ownY, ownNormalX, ownNormalY } = outlines
  const corners = cornersOf(part)
  corners.forEach(([x, y], index) => {
    const [nextX, nextY] = corners[(index + 1) % corners.length]!
    const length = Math.sqrt((nextX - x) * (nextX - x) + (nextY - y) * (nextY - y))
    ownX[first + index] = x
    ownY[first + index] = y
    ownNormalX[first + index] = length > 0 ? (nextY - y) / length : 0
    ownNormalY[first + index] = length > 0 ? (x - nextX) / length : 0
  })
}

const centre = [[0, 0]] as const

function cornersOf(part: Part): readonly (readonly [Cm, Cm])[] {
  return part.kind === 'circle' ? centre : part.corners
}

function reachOf(part: Part): Cm {
  if (part.kind === 'circle') return part.radius
  return Math.max(...part.corners.map(([x, y]) => Math.sqrt(x * x + y * y)))
}

/** Running sums with a 0 in front. */
function starts(counts: readonly number[]): Int32Array {
  const sums = new Int32Array(counts.length + 1)
  counts.forEach((count, index) => (sums[index + 1] = sums[index]! + count))
  return sums
}
