/** Place of the axes' corner and of what is left and right of it, in units of the drawing (210 × 108). */
const [left, bottom, width, height] = [22, 84, 168, 66]
/** Two rounds are not further apart than this. */
const widest = 44
/** So many rounds can bear their number below. */
const numbers = 6

interface Curve {
  readonly spots: readonly { readonly x: number; readonly y: number }[]
  /** The line through them, as an SVG path. */
  readonly path: string
  /** Every so many rounds there is room for a number. */
  readonly every: number
}

/** @param inertia of every round, 0 or more: the largest is as high as the drawing */
export function curveOf(inertia: readonly number[]): Curve {
  const most = Math.max(...inertia, 1e-9)
  const gap = Math.min(widest, width / Math.max(1, inertia.length - 1))
  const spots = inertia.map((value, round) => ({
    x: left + round * gap,
    y: bottom - (value / most) * height,
  }))
  const path = spots.map(({ x, y }, at) => `${at ? 'L' : 'M'}${x} ${y}`).join('')
  return { spots, path, every: Math.ceil(inertia.length / numbers) }
}
