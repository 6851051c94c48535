import fc from 'fast-check'
import { expect, test } from 'vitest'
import { parseTenths } from './numbers.ts'

test.each([
  ['12,5', 12.5],
  ['12.5', 12.5],
  [' 7 ', 7],
  ['−3', -3],
  ['-3', -3],
  [',5', 0.5],
  ['12.54', 12.5],
])('"%s" is %d', (text, number) => {
  expect(parseTenths(text, -100, 100)).toBe(number)
})

test.each(['', 'abc', '1,2,3', '1e3', '--1', '101', '-101', 'Infinity', '.'])('"%s" is refused', (text) => {
  expect(parseTenths(text, -100, 100)).toBeNull()
})

test('any text is a number within the bounds or refused', () => {
  fc.assert(
    fc.property(fc.string(), (text) => {
      const number = parseTenths(text, 0, 10)
      expect(number === null || (number >= 0 && number <= 10)).toBe(true)
    }),
  )
})
