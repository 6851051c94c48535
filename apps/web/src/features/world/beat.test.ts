import { expect, test } from 'vitest'
import { Beat } from './beat.ts'

test('while something runs handles follow once a second', () => {
  const beat = new Beat()
  const frames = Array.from({ length: 179 }, (_, frame) => (frame * 1000) / 60)
  expect(frames.filter((now) => beat.isDue(now, true, false))).toHaveLength(3)
})

test('with a hand near, and where nothing runs, they are always where things are', () => {
  const beat = new Beat()
  expect([0, 16, 33].map((now) => beat.isDue(now, true, true))).toEqual([true, true, true])
  expect([50, 66].map((now) => beat.isDue(now, false, false))).toEqual([true, true])
})
