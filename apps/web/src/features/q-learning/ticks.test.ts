import fc from 'fast-check'
import { expect, test } from 'vitest'
import { ticksOf } from './ticks.ts'

const tries = (...moves: readonly number[]) => {
  let end = 0
  return moves.map((count) => ({ end: (end += count) }))
}

test('each of a few tries has its tick where it ended', () => {
  expect(ticksOf(tries(4, 2, 2), 10)).toEqual([
    { episode: 1, at: 0.4 },
    { episode: 2, at: 0.6 },
    { episode: 3, at: 0.8 },
  ])
})

test('of ten thousand tries every five hundredth has one', () => {
  const ticks = ticksOf(tries(...Array<number>(10_000).fill(9)), 90_000)
  expect(ticks).toHaveLength(20)
  expect(ticks[0]).toEqual({ episode: 500, at: 0.05 })
})

test('there are at most twenty, in order, and none beyond the last move', () => {
  const moves = fc.array(fc.integer({ min: 1, max: 400 }), { maxLength: 3000 })
  fc.assert(
    fc.property(moves, (list) => {
      const made = list.reduce((sum, count) => sum + count, 0)
      const ticks = ticksOf(tries(...list), made)
      const places = ticks.map(({ at }) => at)
      expect(ticks.length).toBeLessThanOrEqual(20)
      expect(ticks.length).toBeGreaterThanOrEqual(Math.min(list.length, 8))
      expect(places).toEqual(places.toSorted((a, b) => a - b))
      expect(places.every((at) => at > 0 && at <= 1)).toBe(true)
    }),
    { seed: 6, numRuns: 60 },
  )
})
