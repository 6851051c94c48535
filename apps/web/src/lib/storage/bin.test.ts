import { expect, test } from 'vitest'
import { daysLeft, isOver } from './bin.ts'

const day = 86_400_000
const thrown = Date.UTC(2026, 10, 1, 9, 30)

test('product.md 8: the bin keeps for 30 days, to the millisecond', () => {
  expect(isOver(thrown, thrown + 30 * day - 1)).toBe(false)
  expect(isOver(thrown, thrown + 30 * day)).toBe(true)
})

test('days left are told as whole ones, the last one as one', () => {
  expect(daysLeft(thrown, thrown)).toBe(30)
  expect(daysLeft(thrown, thrown + day)).toBe(29)
  expect(daysLeft(thrown, thrown + 29.5 * day)).toBe(1)
})

test('a clock that was set back or far ahead gives no odd number', () => {
  expect(daysLeft(thrown, thrown - 9 * day)).toBe(30)
  expect(daysLeft(thrown, thrown + 99 * day)).toBe(1)
})
