import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import type { Floor } from '../types.ts'
import { meanColour, spotOf } from './spot.ts'

const model = readFileSync(new URL('../model.md', import.meta.url), 'utf8')
const radius = Number(/a disc of ([\d.]+) cm radius/.exec(model)?.[1])

/** White, black from `edge` cm on to the right. */
function halved(pixelsPerCm: number, edge: number): Floor {
  const [width, height] = [20 * pixelsPerCm, 20 * pixelsPerCm]
  const data = new Uint8Array(width * height * 3).fill(255)
  for (let at = 0; at < width * height; at++)
    if ((at % width) + 0.5 > edge * pixelsPerCm) data.fill(0, 3 * at, 3 * at + 3)
  return { width, height, pixelsPerCm, data }
}

test.each([2, 3, 4])(
  'at %d pixels a cm the colour sensor sees the disc that model.md says',
  (pixelsPerCm) => {
    const floor = halved(pixelsPerCm, 10)
    const spot = spotOf(floor)
    const area = spot.length / 2 / pixelsPerCm ** 2
    expect(Math.abs(area / (Math.PI * radius ** 2) - 1)).toBeLessThan(1 / 6)
    const mean = new Float64Array(3)
    const seen = (x: number) => (meanColour(floor, spot, x, 10, mean), mean[0])
    // An edge farther off than the radius and half a pixel is not seen, one well within is.
    const far = radius + 0.5 / pixelsPerCm
    expect([seen(10 - far - 0.01), seen(10 + far + 0.01)]).toEqual([255, 0])
    expect(seen(10 - radius / 3)).toBeLessThan(255)
    expect(seen(10 + radius / 3)).toBeGreaterThan(0)
  },
)

test('model.md counts the pixels', () => {
  const counts = [2, 3, 4].map((pixelsPerCm) => spotOf(halved(pixelsPerCm, 10)).length / 2)
  expect(model.replaceAll(/\s+/g, ' ')).toContain(
    `At 2, 3 and 4 pixels a cm these are ${counts[0]}, ${counts[1]} and ${counts[2]}`,
  )
  expect(spotOf(halved(1, 10))).toHaveLength(2)
})
