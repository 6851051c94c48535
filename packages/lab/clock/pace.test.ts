import { expect, test } from 'vitest'
import { Pace } from './pace.ts'

const frame = 1000 / 60
/** Ticks of a second of frames at a speed. */
const second = (speed: number) => {
  const pace = new Pace()
  return Array.from({ length: 60 }, () => pace.ticksFor(frame, speed)).reduce((sum, ticks) => sum + ticks, 0)
}

test.each([
  [0.25, 15],
  [0.5, 30],
  [1, 60],
  [2, 120],
  [4, 240],
  [8, 480],
  [16, 960],
])('at speed %d a second has %d ticks', (speed, ticks) => {
  expect(second(speed)).toBe(ticks)
})

test('a page that was away does not catch up in one leap', () => {
  expect(new Pace().ticksFor(60_000, 1)).toBe(6)
  expect(new Pace().ticksFor(60_000, 16)).toBe(96)
})

test('as fast as it can: there are always more ticks than a frame has time for', () => {
  expect(new Pace().ticksFor(frame, Infinity)).toBe(Infinity)
})
