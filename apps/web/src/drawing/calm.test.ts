import { expect, test } from 'vitest'
import { calm } from './calm.ts'

const frames = Array.from({ length: 16 }, (_, i) => 5 + (i * 1000) / 60)

test('a live value passes in every second or fourth frame, on one beat', () => {
  const second = calm(2)
  const fourth = calm(4)
  expect(frames.map((now) => second(now, true))).toEqual(frames.map((_, i) => i % 2 === 0))
  expect(frames.map((now) => fourth(now, true))).toEqual(frames.map((_, i) => i % 4 === 0))
})

test('what stands still passes at once', () => {
  const turn = calm(30)
  expect([turn(0, true), turn(16, true), turn(17, false), turn(33, true)]).toEqual([true, false, true, false])
})
