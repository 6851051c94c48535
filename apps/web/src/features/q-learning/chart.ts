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
