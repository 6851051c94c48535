import { between, distance, type Point } from './point.ts'

/** A cubic Bézier curve: its ends, and between them the two points that pull it. */
export type Curve = readonly [Point, Point, Point, Point]

/** A curve is halved so often at most: 128 pieces, enough for a cusp. */
const DEEPEST = 7
/** Halved until chord and outline differ by less than this share of the outline. */
const CLOSE = 1e-5

/** J. Gravesen, _Adaptive subdivision and the length and energy of Bézier curves_ (1997), for cubic ones. */
export const curveLength = ([a, b, c, d]: Curve): number =>
  lengthFrom(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y, DEEPEST)

const far = (x: number, y: number) => Math.sqrt(x * x + y * y)

/** In plain numbers, halved by de Casteljau: a hostile map has thousands of cusps. */
// prettier-ignore
function lengthFrom(
  ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number, dy: number, deeper: number,
): number {
  const chord = far(dx - ax, dy - ay)
  const outline = far(bx - ax, by - ay) + far(cx - bx, cy - by) + far(dx - cx, dy - cy)
  if (deeper === 0 || outline - chord <= CLOSE * outline) return (chord + outline) / 2
  const px = (ax + bx) / 2, py = (ay + by) / 2
  const qx = (bx + cx) / 2, qy = (by + cy) / 2
  const rx = (cx + dx) / 2, ry = (cy + dy) / 2
  const sx = (px + qx) / 2, sy = (py + qy) / 2
  const tx = (qx + rx) / 2, ty = (qy + ry) / 2
  const x = (sx + tx) / 2, y = (sy + ty) / 2
  return lengthFrom(ax, ay, px, py, sx, sy, x, y, deeper - 1) + lengthFrom(x, y, tx, ty, rx, ry, dx, dy, deeper - 1)
}

function pointOn([a, b, c, d]: Curve, share: number): Point {
  const rest = 1 - share
  const [p, q] = [rest * rest * rest, 3 * rest * rest * share]
  const [r, s] = [3 * rest * share * share, share * share * share]
  return { x: p * a.x + q * b.x + r * c.x + s * d.x, y: p * a.y + q * b.y + r * c.y + s * d.y }
}

/** So many points of a curve, equally far from one to the next, without its first. */
export function evenly(curve: Curve, count: number): Point[] {
  const pieces = Math.max(64, 4 * count)
  const fine = Array.from({ length: pieces + 1 }, (_, index) => pointOn(curve, index / pieces))
  const gone = [0]
  for (let index = 1; index <= pieces; index++)
    gone.push(gone[index - 1]! + distance(fine[index - 1]!, fine[index]!))
  const points: Point[] = []
  for (let index = 1, next = 1; next < count; next++) {
    const wanted = (gone[pieces]! * next) / count
    while (gone[index]! < wanted) index++
    const [before, after] = [gone[index - 1]!, gone[index]!]
    points.push(between(fine[index - 1]!, fine[index]!, (wanted - before) / (after - before || 1)))
  }
  return [...points, curve[3]]
}
