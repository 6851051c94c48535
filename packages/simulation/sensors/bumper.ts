import type { Ground } from '../geometry/near.ts'
import { bringUpToDate, type Outlines } from '../geometry/outlines.ts'
import type { Cm, SensorPlace } from '../types.ts'

/** The bumper is a bar across the sensor's direction: so far it reaches to both sides, and before and behind its place. */
const HALF_WIDTH = 6
const HALF_DEPTH = 0.15

/** Where a bumper is: its middle and the direction it faces. */
interface Bar {
  x: Cm
  y: Cm
  dx: number
  dy: number
}

const bar: Bar = { x: 0, y: 0, dx: 1, dy: 0 }

/** Does anything press the bumper: a body, another robot, the edge of the floor? `aim`: cos and sin of the sensor's angle. */
export function isBumped(ground: Ground, robot: number, place: SensorPlace, aim: Float64Array): boolean {
  const { outlines } = ground
  const c = outlines.cos[robot]!
  const s = outlines.sin[robot]!
  bar.x = outlines.x[robot]! + c * place.x - s * place.y
  bar.y = outlines.y[robot]! + s * place.x + c * place.y
  bar.dx = c * aim[0]! - s * aim[1]!
  bar.dy = s * aim[0]! + c * aim[1]!
  if (isBeyondEdge(ground)) return true
  for (let body = 0; body < outlines.bodies; body++)
    if (body !== robot && isNear(outlines, body) && isHitBy(outlines, body)) return true
  return false
}

/** Does one end of the bar stick out of the floor? */
function isBeyondEdge({ width, height }: Ground): boolean {
  const aheadX = bar.x + bar.dx * HALF_DEPTH
  const aheadY = bar.y + bar.dy * HALF_DEPTH
  for (const side of [-HALF_WIDTH, HALF_WIDTH]) {
    const x = aheadX - bar.dy * side
    const y = aheadY + bar.dx * side
    if (x < 0 || x > width || y < 0 || y > height) return true
  }
  return false
}

function isNear({ x, y, reach }: Outlines, body: number): boolean {
  const dx = x[body]! - bar.x
  const dy = y[body]! - bar.y
  const far = reach[body]! + HALF_WIDTH + HALF_DEPTH
  return dx * dx + dy * dy <= far * far
}

function isHitBy(outlines: Outlines, body: number): boolean {
  bringUpToDate(outlines, body)
  for (let part = outlines.firstPart[body]!; part < outlines.firstPart[body + 1]!; part++) {
    const radius = outlines.radius[part]!
    if (radius > 0 ? discHits(outlines, part, radius) : polygonHits(outlines, part)) return true
  }
  return false
}

const ahead = (x: Cm, y: Cm) => (x - bar.x) * bar.dx + (y - bar.y) * bar.dy
const aside = (x: Cm, y: Cm) => (y - bar.y) * bar.dx - (x - bar.x) * bar.dy

function discHits({ firstPoint, px, py }: Outlines, part: number, radius: Cm): boolean {
  const point = firstPoint[part]!
  const dx = Math.max(0, Math.abs(ahead(px[point]!, py[point]!)) - HALF_DEPTH)
  const dy = Math.max(0, Math.abs(aside(px[point]!, py[point]!)) - HALF_WIDTH)
  return dx * dx + dy * dy <= radius * radius
}

/** Separating axes: those of the bar, and the normals of the polygon. */
function polygonHits({ firstPoint, px, py, nx, ny }: Outlines, part: number): boolean {
  let [front, back, left, right] = [-Infinity, Infinity, -Infinity, Infinity]
  for (let point = firstPoint[part]!; point < firstPoint[part + 1]!; point++) {
    const x = px[point]!
    const y = py[point]!
    front = Math.max(front, ahead(x, y))
    back = Math.min(back, ahead(x, y))
    left = Math.max(left, aside(x, y))
    right = Math.min(right, aside(x, y))
    const toBar = nx[point]! * (bar.x - x) + ny[point]! * (bar.y - y)
    const along = Math.abs(nx[point]! * bar.dx + ny[point]! * bar.dy)
    const across = Math.abs(ny[point]! * bar.dx - nx[point]! * bar.dy)
    if (toBar - along * HALF_DEPTH - across * HALF_WIDTH > 0) return false
  }
  return front >= -HALF_DEPTH && back <= HALF_DEPTH && left >= -HALF_WIDTH && right <= HALF_WIDTH
}
