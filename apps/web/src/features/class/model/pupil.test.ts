import { expect, test } from 'vitest'
import { waitAfter } from './outbox.ts'
import { passage } from './pupil.ts'

const me = { id: 'a', nickname: 'Fuchs', hand: false, class: { id: 'b', name: '5b', open: true } }

test('"yes" is enough within a lesson, then the pictures are asked, and without the class nobody gets in', () => {
  expect(passage({ ...me, fresh: true }, false)).toBe('through')
  expect(passage({ ...me, fresh: false }, true)).toBe('pictures')
  expect(passage('away', true)).toBe('through')
  expect(passage('away', false)).toBe('locked')
  expect(passage('otherPupil', true)).toBe('signedOut')
  expect(passage('ended', true)).toBe('ended')
  expect(passage('hidden', true)).toBe('hidden')
})

test('after each failure it waits twice as long, at most about a minute', () => {
  expect([1, 2, 3, 20].map((failures) => waitAfter(failures, () => 0.5))).toEqual([2000, 4000, 8000, 60_000])
})
