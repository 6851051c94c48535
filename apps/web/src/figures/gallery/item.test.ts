import fc from 'fast-check'
import { expect, test } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { tilePart } from './item.ts'

const centimetres = fc.double({ min: 20, max: 3000, noNaN: true })

test('a tile shows a part of the floor, never beyond it, with Bo in it', () => {
  fc.assert(
    fc.property(centimetres, centimetres, fc.nat(100), fc.nat(100), (width, height, along, up) => {
      const pose = { x: (along / 100) * width, y: (up / 100) * height, heading: 0 }
      const robot = { ...friendship.world.robots[0]!, pose }
      const part = tilePart({ size: { width, height }, robots: [robot] })
      const [x, y] = [pose.x, height - pose.y]
      const near = 1e-6
      expect(part.left).toBeGreaterThanOrEqual(0)
      expect(part.left + part.width).toBeLessThanOrEqual(width + near)
      expect(part.top).toBeGreaterThanOrEqual(0)
      expect(part.top + part.height).toBeLessThanOrEqual(height + near)
      expect(x).toBeGreaterThanOrEqual(part.left - near)
      expect(x).toBeLessThanOrEqual(part.left + part.width + near)
      expect(y).toBeGreaterThanOrEqual(part.top - near)
      expect(y).toBeLessThanOrEqual(part.top + part.height + near)
    }),
  )
})
