import type { Item } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { allItems, fetchItems } from './library.ts'
import { handOf, readersOf, thumbOf } from './looks.ts'

test('no two sets of cards look alike in the library', async () => {
  await fetchItems('en')
  const looks = allItems.filter(({ kind }) => kind === 'card').map((item) => JSON.stringify(thumbOf(item)))
  expect(looks.length).toBeGreaterThan(3)
  expect(new Set(looks).size).toBe(looks.length)
})

test('words are large and lines high for the youngest alone; teachers read small words', () => {
  const item = (audience: Item['audience'], from: number, to: number) =>
    ({ ...allItems[0]!, audience, grades: [from, to] }) as Item
  expect(readersOf(item('pupils', 3, 4))).toBe('pupils youngest')
  expect(readersOf(item('pupils', 3, 5))).toBe('pupils')
  expect(readersOf(item('teachers', 3, 4))).toBe('')
  expect([3, 4, 5, 6, 7].map((grade) => handOf(item('pupils', grade, 8)))).toEqual([
    ...['from-3', 'from-3', 'from-5', 'from-5', 'from-7'],
  ])
})
