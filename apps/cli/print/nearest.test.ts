import { expect, test } from 'vitest'
import { distance, nearest } from './nearest.ts'

test.each([
  ['kitten', 'sitting', 3],
  ['', 'abc', 3],
  ['q-map', 'q-map', 0],
  ['flaw', 'lawn', 2],
])('from %j to %j it takes %i letters', (from, to, letters) => {
  expect(distance(from, to)).toBe(letters)
})

test('what is nearest to a slip of the finger comes first, and what holds the word before it', () => {
  expect(nearest('q-raillway', ['q-city', 'q-railway', 'meet-bo', 'q-map'])[0]).toBe('q-railway')
  expect(nearest('city', ['q-city', 'cite', 'meet-bo'])).toEqual(['q-city', 'cite', 'meet-bo'])
})
