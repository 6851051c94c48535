import { expect, test } from 'vitest'
import { writeNumber } from './numbers.ts'

test.each([NaN, Infinity, -Infinity])('%s is no number: a dash', (value) => {
  expect(writeNumber(value, 'de')).toBe('–')
})

test('a number has the comma of its language, marks between thousands and a real minus', () => {
  expect([writeNumber(-1234.5678, 'de'), writeNumber(-1234.5678, 'en')]).toEqual(['−1.234,568', '−1,234.568'])
})

test('places, marks, a plus and a percentage are as asked', () => {
  expect(writeNumber(2, 'en', { least: 1 })).toBe('2.0')
  expect(writeNumber(0.126, 'en', { most: 1 })).toBe('0.1')
  expect(writeNumber(12_345, 'en', { grouped: false })).toBe('12345')
  expect([1, 0, -1].map((value) => writeNumber(value, 'en', { plus: true }))).toEqual(['+1', '0', '−1'])
  expect(writeNumber(0.25, 'en', { percent: true })).toBe('25%')
})
