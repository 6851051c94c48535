import { Course, gridMap, layOutWorld, type Settings } from '@botgarten/learning/q-learning'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { Watch } from './watch.svelte.ts'

const settings: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }

/** A corridor with three moves from start to goal, learned to the end. */
function corridor(): Course {
  const course = new Course(layOutWorld(gridMap(['SFFG'])), settings, 1, { episodes: 300, steps: 100_000 })
  course.advance(100_000)
  return course
}

let draw: (milliseconds?: number) => void
beforeEach(() => {
  // Only frames move the clock.
  vi.useFakeTimers({ toFake: ['performance'] })
  draw = screen()
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** Draws frames until `milliseconds` have passed. */
function passes(milliseconds: number) {
  for (let left = milliseconds; left > 0; left -= 100) draw(Math.min(100, left))
}

test('a ride is shown move by move, 700 ms each, and ends after its last one', () => {
  const watch = new Watch()
  expect([watch.on, watch.move]).toEqual([false, null])
  watch.start(corridor(), 1)
  expect([watch.on, watch.count, watch.done]).toEqual([true, 1, false])
  passes(350)
  expect(watch.move).toMatchObject({ from: 0, to: 1 })
  expect(watch.move!.share).toBeCloseTo(0.5)
  passes(700)
  expect(watch.move).toMatchObject({ from: 1, to: 2 })
  passes(700)
  expect(watch.move).toMatchObject({ from: 2, to: 3 })
  expect(watch.done).toBe(false)
  passes(400)
  expect([watch.done, watch.arrived]).toEqual([true, 1])
  // The last move stays.
  expect(watch.move).toEqual({ from: 2, to: 3, share: 1 })
  watch.stop()
  expect(watch.on).toBe(false)
})
