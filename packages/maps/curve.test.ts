import { expect, test } from 'vitest'
import { evenly } from './curve.ts'

test('points of a curve are equally far apart, also where it is drawn slowly', () => {
  // On a straight line from 0 to 100 whose ends are slow: x = 300 t² (1 − t) + 100 t³.
  const [from, to] = [
    { x: 0, y: 0 },
    { x: 100, y: 0 },
  ] as const
  const points = evenly([from, from, to, to], 8)
  expect(points).toHaveLength(8)
  points.forEach(({ x, y }, k) => {
    expect(x).toBeCloseTo((100 * (k + 1)) / 8, 9)
    expect(y).toBe(0)
  })
})
