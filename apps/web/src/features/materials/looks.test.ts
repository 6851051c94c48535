import { expect, test } from 'vitest'
import { allItems, fetchItems } from './library.ts'
import { thumbOf } from './looks.ts'

test('no two sets of cards look alike in the library', async () => {
  await fetchItems('en')
  const looks = allItems.filter(({ kind }) => kind === 'card').map((item) => JSON.stringify(thumbOf(item)))
  expect(looks.length).toBeGreaterThan(3)
  expect(new Set(looks).size).toBe(looks.length)
})
