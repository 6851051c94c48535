import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { gridOf, nearestOthers, visitNear } from './grid.ts'
import { findingsIn, type Table } from './index.ts'
import { farApart } from './types.ts'

const cell = fc.integer({ min: -20, max: 120 })
const points = fc.array(fc.tuple(cell, cell, cell), { minLength: 1, maxLength: 60 })

describe('a grid over readings', () => {
  it('has the same nearest as a look at all of them', () => {
    fc.assert(
      fc.property(points, fc.integer({ min: 1, max: 30 }), (all, side) => {
        const grid = gridOf(all, side)
        all.forEach((point, self) => {
          const others = all.map((other, at) => ({ at, off: farApart(point, other) }))
          const nearest = others
            .filter(({ at }) => at !== self)
            .sort((a, b) => a.off - b.off || a.at - b.at)
            .slice(0, 4)
          expect(nearestOthers(grid, self, 4)).toEqual(nearest.map(({ at }) => at))
        })
      }),
      { seed: 5, numRuns: 60 },
    )
  })

  it('has all within a side of it in the cells around, each once', () => {
    fc.assert(
      fc.property(points, fc.integer({ min: 1, max: 30 }), (all, side) => {
        const grid = gridOf(all, side)
        all.forEach((point) => {
          const seen: number[] = []
          visitNear(grid, point, (at) => seen.push(at))
          expect(new Set(seen).size).toBe(seen.length)
          all.forEach((other, at) => farApart(point, other) < side && expect(seen).toContain(at))
        })
      }),
      { seed: 6, numRuns: 60 },
    )
  })
})

describe('5,000 examples', () => {
  /** Most of them far from any wall, as in a drive; every tenth is against the others. */
  const pairs = Array.from({ length: 5000 }, (_, row) => {
    const near = row % 2 === 0 ? 0 : (row * 7) % 90
    const wish = row % 10 === 0 ? -60 : 50
    return { row, drive: 0, inputs: [100 - near, 100 - near / 2], outputs: [wish, 50 + (row % 7)] }
  })
  const table: Table = {
    ...{ pairs, inputs: ['l', 'r'], outputs: ['m', 'n'] },
    ...{ wheels: { left: 0, right: 1 }, mirror: null, knobs: 4 },
  }

  it('are asked about as well, those first that fit fewest', () => {
    const found = findingsIn(table)
    const [first] = found
    expect(first).toMatchObject({ kind: 'blind' })
    expect('row' in first! && first.row % 10).toBe(0)
    expect(found.filter(({ kind }) => kind === 'blind' || kind === 'contradiction').length).toBe(500)
  })
})
