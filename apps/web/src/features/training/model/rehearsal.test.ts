import { expect, test } from 'vitest'
import { nearestRound } from './rehearsal.ts'

const curve = (...rounds: readonly number[]) => rounds.map((round) => ({ round, practised: 1, kept: null }))

test('the nearest measured round is the only one of a curve with one point, else the closest one', () => {
  expect(nearestRound(curve(0), 40)).toBe(0)
  expect([4, 6, 99].map((round) => nearestRound(curve(0, 10, 20), round))).toEqual([0, 10, 20])
})
