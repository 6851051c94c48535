import { atan2 } from '@botgarten/numbers'
import { degreesOf } from '../angles.ts'
import type { Cm, Pose, Shape } from '../types.ts'

interface Corner {
  readonly x: Cm
  readonly y: Cm
}

const lengthOf = ({ x, y }: Corner) => Math.sqrt(x * x + y * y)
const minus = (a: Corner, b: Corner): Corner => ({ x: a.x - b.x, y: a.y - b.y })

/** The triangle with these three corners, standing on its longest side. null where they lie on one line. */
export function triangleOf(a: Corner, b: Corner, c: Corner): { shape: Shape; pose: Pose } | null {
  const sides = [[a, b, c], [b, c, a], [c, a, b]] as const // prettier-ignore
  const long = sides.reduce((best, side) =>
    lengthOf(minus(side[1], side[0])) > lengthOf(minus(best[1], best[0])) ? side : best,
  )
  const tip = long[2]
  const isLeft = across(long[0], long[1], tip) > 0
  const [from, to] = isLeft ? [long[0], long[1]] : [long[1], long[0]]
  const width = lengthOf(minus(to, from))
  const height = across(from, to, tip) / width
  if (!(height > 0)) return null
  const u = { x: (to.x - from.x) / width, y: (to.y - from.y) / width }
  const along = (tip.x - from.x) * u.x + (tip.y - from.y) * u.y
  const x = (from.x + to.x) / 2 - (u.y * height) / 2
  const y = (from.y + to.y) / 2 + (u.x * height) / 2
  return {
    shape: { kind: 'triangle', width, height, tip: along - width / 2 },
    pose: { x, y, heading: degreesOf(atan2(u.y, u.x)) },
  }
}

/** Twice the area left of the way from `from` to `to`, up to `point`. */
function across(from: Corner, to: Corner, point: Corner): number {
  const along = minus(to, from)
  const aside = minus(point, from)
  return along.x * aside.y - along.y * aside.x
}
