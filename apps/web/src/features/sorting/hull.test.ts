import fc from 'fast-check'
import { expect, test } from 'vitest'
import { hullOf, type Spot } from './hull.ts'

const spots = fc.array(
  fc.record({ x: fc.integer({ min: 0, max: 50 }), y: fc.integer({ min: 0, max: 50 }) }),
  {
    minLength: 3,
    maxLength: 40,
  },
)
const left = (a: Spot, b: Spot, c: Spot) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)

test('a hull has every spot on its left side or on it', () => {
  fc.assert(
    fc.property(spots, (all) => {
      const hull = hullOf(all)
      hull.forEach((from, index) => {
        const to = hull[(index + 1) % hull.length]!
        for (const spot of all) expect(left(from, to, spot)).toBeGreaterThanOrEqual(0)
      })
    }),
  )
})

test('of a square with a spot inside it is the square', () => {
  const square = [
    { x: 0, y: 0 },
    { x: 4, y: 0 },
    { x: 4, y: 4 },
    { x: 0, y: 4 },
  ]
  expect(hullOf([...square, { x: 2, y: 2 }])).toEqual(square)
})
