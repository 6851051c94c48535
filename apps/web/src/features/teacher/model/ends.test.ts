import { expect, test } from 'vitest'
import { dayFrom, endOfHalfYear, dayLabel } from './ends.ts'

test.each([
  ['2026-11-24', '2027-01-31'],
  ['2027-01-02', '2027-01-31'],
  ['2027-01-20', '2027-07-31'],
  ['2027-07-10', '2028-01-31'],
  ['2027-12-31', '2028-01-31'],
])('a class that is made on %s ends with the half-year on %s', (today, end) => {
  const [year, month, day] = today.split('-').map(Number)
  expect(endOfHalfYear(new Date(year!, month! - 1, day))).toBe(end)
})

test('days are counted over the end of a month and a year', () => {
  expect(dayFrom('2027-01-31', -14)).toBe('2027-01-17')
  expect(dayFrom('2027-01-05', -14)).toBe('2026-12-22')
})

test('a day is written in the language of the page', () => {
  expect(dayLabel('2027-01-31', 'en')).toBe('31 January 2027')
  expect(dayLabel('2027-01-31', 'de')).toBe('31. Januar 2027')
})
