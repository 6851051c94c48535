import { expect, test } from 'vitest'
import { sproutsFor } from './sprouts.ts'

test('sprouts stand evenly from one end of the bed to the other, one alone in the middle', () => {
  const at = (count: number) => sproutsFor(count).map(({ x }) => x)
  const [left, right] = at(2) as [number, number]
  // The bed is 1366 wide.
  expect([at(1), left + right]).toEqual([[683], 1366])
  expect(at(3)).toEqual([left, 683, right])
  expect(sproutsFor(100)).toHaveLength(60)
})

test('sprouts of one bed differ by less than half, and are smaller where there are many', () => {
  const sizes = sproutsFor(19).map(({ scale }) => scale)
  expect(Math.max(...sizes)).toBeLessThan(1.5 * Math.min(...sizes))
  // Up to 26 / count + 0.25 = 1 a bed has room for all of them.
  expect(Math.max(...sproutsFor(60).map(({ scale }) => scale))).toBeLessThan(Math.min(...sizes))
})
