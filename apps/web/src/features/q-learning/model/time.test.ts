import fc from 'fast-check'
import { expect, test } from 'vitest'
import { isReached, phaseAt, phases, rideAt, ticksOf, timesOf, timeShown } from './time.ts'

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

test('of a short limit what is left is shown, and never less than nothing', () => {
  expect(timeShown(1000, 47)).toEqual({ key: 'timeLeft', seconds: 953 })
  expect(timeShown(20, 21)).toEqual({ key: 'timeLeft', seconds: 0 })
})

test('of a limit of hours nobody is told that 9,999 s are left, but what has passed', () => {
  expect(timeShown(10_000, 1)).toEqual({ key: 'timePassed', seconds: 1 })
})

test('a move goes through its phases in order, inside one second', () => {
  const seen = Array.from({ length: 101 }, (_, k) => phaseAt(k / 100))
  expect([...new Set(seen)]).toEqual([...phases])
  for (const phase of phases) expect(timesOf(phase, 1).begins).toBeLessThan(1000)
})

test('what a phase shows stays a whole move: a second at ×1, and true multiples', () => {
  expect([1, 2, 3].map((speed) => Math.round(timesOf('decide', speed).stays))).toEqual([1000, 500, 333])
})

test('Bo rides between the decision and the reward, and never backwards', () => {
  expect([rideAt(0), rideAt(0.4), rideAt(0.75), rideAt(1)]).toEqual([0, 0, 1, 1])
  const all = Array.from({ length: 101 }, (_, k) => rideAt(k / 100))
  expect(all).toEqual(all.toSorted((a, b) => a - b))
  expect(isReached('reward', 0.74)).toBe(false)
})
