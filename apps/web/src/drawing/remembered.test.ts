import { expect, test } from 'vitest'
import { Remembered } from './remembered.ts'

test('what was made for a key is the same object the next time, and not so many are held', () => {
  const all = new Remembered<{ readonly key: string }>()
  const of = (key: string) => all.of(key, () => ({ key }))
  const first = of('a')
  expect(of('a')).toBe(first)
  for (let i = 0; i < 500; i += 1) of(String(i))
  expect(of('a')).not.toBe(first)
})
