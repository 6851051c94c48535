import { expect, test } from 'vitest'
import { isReached, phaseAt, phases, rideAt, timesOf } from './phases.ts'

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
