import type { Cm, Floor } from '../types.ts'

/** A colour sensor sees a disc of this radius. */
const RADIUS: Cm = 0.8

/** Columns and rows of the pixels in the disc, relative to its middle one: dx0, dy0, dx1, dy1, … */
export function spotOf(floor: Floor): Int32Array {
  const radius = RADIUS * floor.pixelsPerCm
  const reach = Math.floor(radius)
  const pixels: number[] = []
  for (let dy = -reach; dy <= reach; dy++)
    for (let dx = -reach; dx <= reach; dx++) if (dx * dx + dy * dy <= radius * radius) pixels.push(dx, dy)
  return Int32Array.from(pixels)
}

/** Mean red, green and blue, 0..255, of the disc round a place; outside the floor its nearest pixels count. */
export function meanColour(floor: Floor, spot: Int32Array, x: Cm, y: Cm, mean: Float64Array): void {
  const { width, height, pixelsPerCm, data } = floor
  const column = Math.floor(x * pixelsPerCm)
  const row = height - 1 - Math.floor(y * pixelsPerCm)
  let r = 0
  let g = 0
  let b = 0
  for (let pixel = 0; pixel < spot.length; pixel += 2) {
    const at = (within(row + spot[pixel + 1]!, height) * width + within(column + spot[pixel]!, width)) * 3
    r += data[at]!
    g += data[at + 1]!
    b += data[at + 2]!
  }
  const count = spot.length / 2
  mean[0] = r / count
  mean[1] = g / count
  mean[2] = b / count
}

const within = (at: number, length: number) => (at < 0 ? 0 : at >= length ? length - 1 : at)
