import fc from 'fast-check'
import { expect, test } from 'vitest'
import { distanceToSegment } from '#drawing/points.ts'
import { drawnTo, smoothed } from './strokes.ts'

const point = fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 200 }) })

test('a smoothed line begins and ends where the hand did and is never far from what it drew', () => {
  fc.assert(
    fc.property(fc.array(point, { minLength: 2, maxLength: 60 }), (points) => {
      const line = smoothed(points, 1000)
      expect([line[0], line.at(-1)]).toEqual([points[0], points.at(-1)])
      for (const drawn of points) {
        const away = line.slice(1).map((to, index) => distanceToSegment(line[index]!, to, drawn))
        expect(Math.min(...away)).toBeLessThanOrEqual(0.7)
      }
    }),
  )
})

test('a straight line is two points, however long it took', () => {
  const points = Array.from({ length: 500 }, (_, x) => ({ x: x / 10, y: x / 20 }))
  expect(smoothed(points, 1000)).toEqual([points[0], points[499]])
})

test('there are never more than may be kept', () => {
  const zigzag = Array.from({ length: 3000 }, (_, x) => ({ x, y: x % 2 ? 50 : 0 }))
  expect(smoothed(zigzag, 1000)).toHaveLength(1000)
})

test('a pen that hardly moves draws no further point', () => {
  expect(drawnTo([{ x: 0, y: 0 }], { x: 0.5, y: 0 })).toHaveLength(1)
  expect(drawnTo([{ x: 0, y: 0 }], { x: 1.5, y: 0 })).toHaveLength(2)
})
