import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { dotsAlong } from './trail.ts'

const points = fc.array(
  fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 300 }) }),
  { maxLength: 20 },
)

describe('a trail', () => {
  test('has dots at equal distances along its way', () => {
    const { dots } = dotsAlong(
      [
        { x: 0, y: 0 },
        { x: 25, y: 0 },
        { x: 25, y: 20 },
      ],
      10,
    )
    expect(dots).toEqual([
      { x: 0, y: 0 },
      { x: 10, y: 0 },
      { x: 20, y: 0 },
      { x: 25, y: 5 },
      { x: 25, y: 15 },
    ])
  })

  test('dotted piece by piece is the trail dotted at once', () => {
    fc.assert(
      fc.property(points, fc.nat(20), (way, cut) => {
        const first = dotsAlong(way.slice(0, cut), 7)
        const second = dotsAlong(way.slice(cut), 7, first.dotting)
        expect([...first.dots, ...second.dots]).toEqual(dotsAlong(way, 7).dots)
      }),
    )
  })
})
