import type { Cm, Colour, Floor } from '../types.ts'
import { colourOf } from './colours.ts'

/** Cm between two points of the floor that are read. */
const apart: Cm = 1
/** A colour on a smaller share of these points is an edge between two others, not a colour of the floor. */
const least = 1 / 1000

/** The colours of the eight that a sensor can name which are on the floor, the largest area first. */
export function coloursOn(floor: Floor): readonly Colour[] {
  const { width, height, pixelsPerCm, data } = floor
  const stride = Math.max(1, Math.round(apart * pixelsPerCm))
  const counts = new Map<Colour, number>()
  let points = 0
  for (let row = 0; row < height; row += stride)
    for (let column = 0; column < width; column += stride) {
      const at = (row * width + column) * 3
      const colour = colourOf(data[at]!, data[at + 1]!, data[at + 2]!)
      if (colour) counts.set(colour, (counts.get(colour) ?? 0) + 1)
      points += 1
    }
  return [...counts]
    .filter(([, count]) => count >= points * least)
    .sort(([, a], [, b]) => b - a)
    .map(([colour]) => colour)
}
