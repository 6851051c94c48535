import fc from 'fast-check'
import { expect, test } from 'vitest'
import { leaders } from './leaders.ts'

const spot = fc.record({ x: fc.integer({ min: -9, max: 9 }), y: fc.integer({ min: -9, max: 9 }) })

test('a name stands beside what it names where nothing is in the way', () => {
  expect(
    leaders(
      [
        { x: -2, y: 1 },
        { x: 3, y: 0 },
        { x: -2, y: 7 },
      ],
      4,
    ),
  ).toEqual([
    { side: 'left', y: 1 },
    { side: 'right', y: 0 },
    { side: 'left', y: 7 },
  ])
})

test('names that would cover each other make way both alike', () => {
  expect(
    leaders(
      [
        { x: 1, y: 1 },
        { x: 1, y: 0 },
      ],
      4,
    ),
  ).toEqual([
    { side: 'right', y: 2.5 },
    { side: 'right', y: -1.5 },
  ])
})

test('what stands in the middle is named where there is less', () => {
  const [, , eye] = leaders(
    [
      { x: 1, y: 0 },
      { x: 1, y: 5 },
      { x: 0, y: 2 },
    ],
    1,
  )
  expect(eye).toEqual({ side: 'left', y: 2 })
})

test('names never cover each other and stand in the order of what they name', () => {
  fc.assert(
    fc.property(fc.array(spot, { maxLength: 9 }), (spots) => {
      const named = leaders(spots, 3).map((leader, at) => ({ ...leader, spot: spots[at]! }))
      for (const a of named)
        for (const b of named) {
          if (a === b || a.side !== b.side) continue
          expect(Math.abs(a.y - b.y)).toBeGreaterThanOrEqual(3 - 1e-9)
          if (a.spot.y < b.spot.y) expect(a.y).toBeLessThan(b.y)
        }
    }),
    { seed: 5 },
  )
})
