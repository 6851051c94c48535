import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { partedTops, type Box } from './parted.ts'

const box = (left: number, top: number, width = 100, height = 50): Box => ({ left, top, width, height })
const size = fc.integer({ min: 1, max: 400 })
const place = fc.integer({ min: -600, max: 600 })
const boxes = fc.array(fc.record({ left: place, top: place, width: size, height: size }), { maxLength: 40 })

const overlap = (a: Box, b: Box) =>
  a.left < b.left + b.width &&
  b.left < a.left + a.width &&
  a.top < b.top + b.height &&
  b.top < a.top + a.height

describe('boxes that are parted', () => {
  it('stay where they lie on nothing', () => {
    expect(partedTops([box(0, 0), box(0, 50), box(100, 20)], 16)).toEqual([0, 50, 20])
  })

  it('move down, those that come later, and keep a gap', () => {
    expect(partedTops([box(0, 0), box(50, 30)], 16)).toEqual([0, 66])
    expect(partedTops([box(50, 30), box(0, 0)], 16)).toEqual([30, 96])
  })

  it('pass everything that is in their way', () => {
    expect(partedTops([box(0, 60), box(0, 0), box(0, 10)], 10)).toEqual([60, 0, 120])
  })

  it('never lie on each other, never move up, and the first one stays', () => {
    fc.assert(
      fc.property(boxes, fc.integer({ min: 0, max: 30 }), (all, gap) => {
        const after = partedTops(all, gap).map((top, at) => ({ ...all[at]!, top }))
        expect(after.some((a, i) => after.some((b, k) => i < k && overlap(a, b)))).toBe(false)
        expect(after.every(({ top }, at) => top >= all[at]!.top)).toBe(true)
        expect(after[0]?.top).toBe(all[0]?.top)
      }),
      { seed: 4 },
    )
  })
})
