import type { QWorld } from '@botgarten/learning/q-learning'
import { arrowOn, ridden, type Road } from '#figures/map/roads.ts'

/** At most so many points are drawn of a curve: each is the mean of its share of the episodes. */
const POINTS = 160

/** Means of equal slices; slices without a number are left out. `x` 0..1 of all episodes. */
export function thinned(
  values: readonly (number | null)[],
  most = POINTS,
): readonly { readonly x: number; readonly y: number }[] {
  const count = Math.min(most, values.length)
  return Array.from({ length: count }, (_, slice) => {
    const from = Math.floor((slice * values.length) / count)
    const to = Math.floor(((slice + 1) * values.length) / count)
    const own = values.slice(from, to).filter((value) => value !== null)
    return {
      x: values.length > 1 ? from / (values.length - 1) : 0,
      y: own.reduce((a, b) => a + b, 0) / own.length,
    }
  }).filter(({ y }) => Number.isFinite(y))
}

/** Path data in a box, y upwards, from 0 to `highest`. */
export function curveOf(
  points: readonly { readonly x: number; readonly y: number }[],
  width: number,
  height: number,
  highest: number,
): string {
  const at = ({ x, y }: { readonly x: number; readonly y: number }) =>
    `${(x * width).toFixed(1)} ${(height - (y / highest) * height).toFixed(1)}`
  return points.map((point, index) => `${index === 0 ? 'M' : 'L'}${at(point)}`).join('')
}

/** So far from a station's middle an arrow lies: just outside of its disc. */
const ASIDE = 78

/** Corners of an arrow that points to the right. */
const corners = [
  { x: -11, y: -15 },
  { x: 15, y: 0 },
  { x: -11, y: 15 },
]

/** By move the path data of its arrow; '' where no road is drawn. Once a world. */
export function arrowsOf({ from, meant }: QWorld, roads: readonly Road[]): readonly string[] {
  return Array.from(meant, (to, move) => {
    const points = ridden(roads, from[move]!, to)
    if (points.length < 2) return ''
    const { x, y, turn } = arrowOn(points, Math.min(0.4, ASIDE / lengthOf(points)))
    const [c, s] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)]
    const turned = corners.map(
      (at) => `${(x + c * at.x - s * at.y).toFixed(1)} ${(y + s * at.x + c * at.y).toFixed(1)}`,
    )
    return `M${turned.join('L')}z`
  })
}

const lengthOf = (points: readonly { readonly x: number; readonly y: number }[]) =>
  points
    .slice(1)
    .reduce((sum, { x, y }, index) => sum + Math.hypot(x - points[index]!.x, y - points[index]!.y), 0)
