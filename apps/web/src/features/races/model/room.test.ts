import { expect, test } from 'vitest'
import { placesOf } from './room.ts'

const doors = (count: number) => Array.from({ length: count }, (_, to) => ({ action: to, to, side: null }))

test('doors of a grid stand on their sides', () => {
  const sides = ['left', 'down', 'right', 'up'].map((side, to) => ({ action: to, to, side }))
  const [left, down, right, up] = placesOf(sides)
  expect(left!.x).toBeLessThan(right!.x)
  expect(up!.y).toBeLessThan(down!.y)
})

test('up to eight doors stand in a ring, none on another or on the room itself', () => {
  for (let count = 1; count <= 8; count++) {
    const places = placesOf(doors(count))
    places.forEach(({ x, y }, one) => {
      expect(Math.hypot(x - 0.5, y - 0.5)).toBeGreaterThan(0.3)
      for (const other of places.slice(one + 1))
        expect(Math.hypot(x - other.x, y - other.y)).toBeGreaterThan(0.2)
    })
  }
})
