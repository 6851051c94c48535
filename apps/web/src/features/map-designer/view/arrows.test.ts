import { lineOf } from '@botgarten/maps/own'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { chipSpot, middleOf, ridingArrows } from './arrows.ts'

const numbersIn = (path: string) => [...path.matchAll(/-?[\d.]+ -?[\d.]+/g)].map(([pair]) => pair.split(' ').map(Number) as [number, number]) // prettier-ignore

describe('arrows along a one-way road', () => {
  test('point the way it leads, at about a third and two thirds of it', () => {
    const arrows = ridingArrows('M100 500L900 500').split(/(?<=L\S+ \S+)(?=M\S+ \S+L\S+ \S+M)/)
    expect(arrows).toHaveLength(2)
    const tips = arrows.map((arrow) => numbersIn(arrow)[3]!)
    // Points of a road are 8 units apart; the tip is 22 units before the middle of its arrow.
    for (const [index, share] of [0.35, 0.65].entries()) {
      expect(Math.abs(tips[index]![0] - 22 - (100 + 800 * share))).toBeLessThanOrEqual(8)
      expect(tips[index]![1]).toBe(500)
    }
  })

  test('are as wide on both sides, whatever way the road leads', () => {
    const place = fc.record({ x: fc.integer({ min: 80, max: 1520 }), y: fc.integer({ min: 80, max: 920 }) })
    fc.assert(
      fc.property(place, place, (from, to) => {
        fc.pre(Math.hypot(to.x - from.x, to.y - from.y) > 100)
        const stations = [from, to]
        const line = lineOf({ stations }, { from: 0, to: 1, bends: [] }).there
        const [back, front, left, tip, right] = numbersIn(ridingArrows(line))
        const [dx, dy] = [front![0] - back![0], front![1] - back![1]]
        expect(dx * (to.x - from.x) + dy * (to.y - from.y)).toBeGreaterThan(0)
        // Coordinates are written to a tenth.
        expect(Math.abs(Math.hypot(dx, dy) - 46)).toBeLessThan(0.2)
        const width = ([x, y]: [number, number]) => Math.hypot(x - tip![0], y - tip![1])
        expect(Math.abs(width(left!) - width(right!))).toBeLessThan(0.3)
      }),
    )
  })

  test('are not drawn where a road has no room for them', () => {
    expect([ridingArrows('M100 500L104 500'), ridingArrows('')]).toEqual(['', ''])
  })
})

test('the middle of a road is where it is half over; of no road it is the corner', () => {
  const { x, y } = middleOf('M100 500L900 500')
  expect(Math.abs(x - 500)).toBeLessThanOrEqual(8)
  expect(y).toBe(500)
  expect(middleOf('')).toEqual({ x: 0, y: 0 })
})

describe('the note of a place', () => {
  const [width, height] = [168, 54]

  test('stands where it is farthest from all stations', () => {
    // A station at the upper left pushes it to the lower right.
    expect(chipSpot({ x: 800, y: 500 }, [{ x: 680, y: 430 }])).toEqual({
      x: 920 - width / 2,
      y: 570 - height / 2,
    })
  })

  test('is always on the paper, next to a place that is on it', () => {
    const place = fc.record({ x: fc.integer({ min: 80, max: 1520 }), y: fc.integer({ min: 80, max: 920 }) })
    fc.assert(
      fc.property(place, fc.array(place, { minLength: 1, maxLength: 6 }), (at, stations) => {
        const { x, y } = chipSpot(at, stations)
        expect(x >= 0 && x + width <= 1600 && y >= 0 && y + height <= 1000).toBe(true)
      }),
    )
  })
})
