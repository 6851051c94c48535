import { sampled } from '@botgarten/maps/own'

interface Point {
  readonly x: number
  readonly y: number
}

const shares = [0.35, 0.65]

/** Two arrows along a one-way road, as path data. */
export function ridingArrows(line: string): string {
  const points = sampled(line)
  return points.length < 3 ? '' : shares.map((share) => arrowAt(points, share)).join('')
}

/** Where a road is half over. */
export function middleOf(line: string): Point {
  const points = sampled(line)
  return points[Math.floor(points.length / 2)] ?? { x: 0, y: 0 }
}

function arrowAt(points: readonly Point[], share: number): string {
  const index = Math.min(points.length - 2, Math.max(1, Math.floor(points.length * share)))
  const [from, at, tip] = [points[index - 1]!, points[index]!, points[index + 1]!]
  const length = Math.hypot(tip.x - from.x, tip.y - from.y) || 1
  const [x, y] = [(tip.x - from.x) / length, (tip.y - from.y) / length]
  const to = (along: number, aside: number) =>
    `${(at.x + along * x - aside * y).toFixed(1)} ${(at.y + along * y + aside * x).toFixed(1)}`
  return `M${to(-26, 0)}L${to(20, 0)}M${to(2, -15)}L${to(22, 0)}L${to(2, 15)}`
}

/** Size of what is measured, in units. */
const CHIP = { width: 168, height: 54 }

/** Where the note of a place stands: beside it, where it is farthest from all stations and on the paper. */
export function chipSpot({ x, y }: Point, stations: readonly Point[]): Point {
  const corners = [-1, 1].flatMap((side) => [-1, 1].map((high) => ({ x: x + side * 120, y: y + high * 70 })))
  const inside = corners.filter((at) => at.x > 90 && at.x < 1510 && at.y > 40 && at.y < 960)
  const gap = (at: Point) => Math.min(...stations.map((one) => Math.hypot(one.x - at.x, one.y - at.y)))
  const best = (inside.length > 0 ? inside : corners).toSorted((a, b) => gap(b) - gap(a))[0]!
  return { x: best.x - CHIP.width / 2, y: best.y - CHIP.height / 2 }
}
