import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { dayHere } from './ports.ts'

const zone = process.env['TZ']
beforeEach(() => {
  process.env['TZ'] = 'Europe/Berlin'
  vi.useFakeTimers({ toFake: ['Date'] })
})
afterEach(() => {
  vi.useRealTimers()
  if (zone === undefined) delete process.env['TZ']
  else process.env['TZ'] = zone
})

// Berlin is two hours ahead of UTC from 28 March to 31 October 2027, and one hour in the rest of the year.
test.each([
  ['a minute before midnight', '2027-02-28T22:59:00Z', ['2027-02-27', '2027-02-28', '2027-03-01']],
  ['at midnight', '2027-02-28T23:00:00Z', ['2027-02-28', '2027-03-01', '2027-03-02']],
  [
    'before the hour that is left out in spring',
    '2027-03-28T00:30:00Z',
    ['2027-03-27', '2027-03-28', '2027-03-29'],
  ],
  ['late on the day with 23 hours', '2027-03-28T21:30:00Z', ['2027-03-27', '2027-03-28', '2027-03-29']],
  ['early on the day with 25 hours', '2027-10-30T22:30:00Z', ['2027-10-30', '2027-10-31', '2027-11-01']],
  ['in the hour that comes twice', '2027-10-31T01:30:00Z', ['2027-10-30', '2027-10-31', '2027-11-01']],
  ['late on the day with 25 hours', '2027-10-31T22:30:00Z', ['2027-10-30', '2027-10-31', '2027-11-01']],
])('%s yesterday, today and tomorrow are days of the calendar', (_, time, days) => {
  vi.setSystemTime(new Date(time))
  expect([-1, 0, 1].map(dayHere)).toEqual(days)
})
