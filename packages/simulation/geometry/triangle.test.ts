import fc from 'fast-check'
import { expect, test } from 'vitest'
import { partOfShape } from './parts.ts'
import { triangleOf } from './triangle.ts'

const corner = fc.record({
  x: fc.integer({ min: -200, max: 200 }),
  y: fc.integer({ min: -200, max: 200 }),
})

test('a triangle has the corners it was made from', () => {
  fc.assert(
    fc.property(corner, corner, corner, (a, b, c) => {
      const found = triangleOf(a, b, c)
      const area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
      expect(found === null).toBe(area === 0)
      if (!found) return
      const part = partOfShape(found.shape)
      if (part.kind !== 'polygon') return expect.fail()
      const turn = (found.pose.heading * Math.PI) / 180
      const corners = part.corners.map(([x, y]) => ({
        x: found.pose.x + x * Math.cos(turn) - y * Math.sin(turn),
        y: found.pose.y + x * Math.sin(turn) + y * Math.cos(turn),
      }))
      for (const wanted of [a, b, c])
        expect(Math.min(...corners.map(({ x, y }) => Math.hypot(x - wanted.x, y - wanted.y)))).toBeLessThan(
          1e-6,
        )
    }),
  )
})
