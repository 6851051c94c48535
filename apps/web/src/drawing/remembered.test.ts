import { expect, test } from 'vitest'
import { Remembered, sameOnes } from './remembered.ts'

test('what was made for a key is the same object the next time, and not so many are held', () => {
  const all = new Remembered<{ readonly key: string }>()
  const of = (key: string) => all.of(key, () => ({ key }))
  const first = of('a')
  expect(of('a')).toBe(first)
  for (let i = 0; i < 500; i += 1) of(String(i))
  expect(of('a')).not.toBe(first)
})

test('what is the same stays the object it was', () => {
  const before = [
    { id: 1, at: 5 },
    { id: 2, at: 6 },
  ]
  const next = sameOnes(
    before,
    [
      { id: 2, at: 6 },
      { id: 1, at: 7 },
    ],
    ({ id }) => id,
    (a, b) => a.at === b.at,
  )
  expect(next).toEqual([
    { id: 2, at: 6 },
    { id: 1, at: 7 },
  ])
  expect(next[0]).toBe(before[1])
})
