import { heatOf } from '#drawing/colours.ts'
import { spread, type Range } from '../model/function.ts'

/** Does this pixel of a negative value belong to a stripe? */
const isStriped = (x: number, y: number): boolean => (x + y) % 6 < 2

/** Paints what follows from two numbers as a square of pixels, the second number upwards. Below 0 stripes lie over it. */
export function paintHeat(
  context: CanvasRenderingContext2D,
  answer: (x: number, y: number) => number,
  ranges: readonly [x: Range, y: Range],
  cells: number,
): void {
  const picture = context.createImageData(cells, cells)
  const pixels = new Uint32Array(picture.data.buffer)
  const [across, up] = ranges.map((range) => spread(range, cells)) as [readonly number[], readonly number[]]
  for (let row = 0; row < cells; row++)
    for (let column = 0; column < cells; column++) {
      const one = answer(across[column]!, up[cells - 1 - row]!)
      pixels[row * cells + column] = pixelOf(one < 0 && isStriped(column, row) ? '#6F8596' : heatOf(one))
    }
  context.putImageData(picture, 0, 0)
}

/** `#RRGGBB` as a pixel in memory. */
function pixelOf(colour: string): number {
  const [r, g, b] = [1, 3, 5].map((from) => parseInt(colour.slice(from, from + 2), 16))
  return (255 << 24) | (b! << 16) | (g! << 8) | r!
}
