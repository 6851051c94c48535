import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { layoutNetwork, ringFill } from './network.ts'

const rooms = fc.record({
  width: fc.integer({ min: 340, max: 1400 }),
  height: fc.integer({ min: 160, max: 900 }),
})
const count = fc.integer({ min: 1, max: 9 })

describe('the nodes of a network', () => {
  test('are never smaller than a finger and never touch, whatever their number', () => {
    fc.assert(
      fc.property(rooms, count, count, (room, inputs, outputs) => {
        const { radius, columns, stage } = layoutNetwork(room, inputs, outputs)
        const [left = [], right = []] = columns
        expect(radius).toBeGreaterThanOrEqual(22)
        for (const column of [left, right])
          for (let i = 1; i < column.length; i++)
            expect(column[i]!.y - column[i - 1]!.y).toBeGreaterThanOrEqual(2 * radius + 12 - 1e-6)
        expect(right[0]!.x - left[0]!.x).toBeGreaterThan(2 * radius + 60)
        for (const { y } of [...left, ...right]) expect(y + radius <= stage.height && y >= radius).toBe(true)
      }),
    )
  })

  test('leave 52 px over the middle of the first row, for the label of its weight', () => {
    fc.assert(
      fc.property(rooms, count, (room, size) => {
        expect(layoutNetwork(room, size, size).columns[0]![0]!.y).toBeGreaterThanOrEqual(52 - 1e-9)
      }),
    )
  })

  test('fill the room while they can, and scroll when they must', () => {
    const fits = layoutNetwork({ width: 456, height: 416 }, 2, 2)
    expect(fits.stage.height).toBe(416)
    // As large as in the picture of the lab.
    expect(fits.radius).toBeGreaterThanOrEqual(46)
    expect(layoutNetwork({ width: 456, height: 300 }, 8, 2).stage.height).toBeGreaterThan(600)
  })

  test('a lone node stands in the middle of the other side', () => {
    const [inputs, outputs] = layoutNetwork({ width: 500, height: 400 }, 1, 3).columns
    expect(inputs![0]!.y).toBeCloseTo(outputs![1]!.y)
  })
})

describe('a ring', () => {
  test('is full at 100, and a negative value fills it the other way (rule 11)', () => {
    expect(ringFill(55)).toEqual({ share: 0.55, backwards: false })
    expect(ringFill(180)).toEqual({ share: 1, backwards: false })
    expect(ringFill(-40)).toEqual({ share: 0.4, backwards: true })
  })
})
