import { expect, test } from 'vitest'
import { timeShown } from './time-shown.ts'

test('of a short limit what is left is shown, and never less than nothing', () => {
  expect(timeShown(1000, 47)).toEqual({ key: 'timeLeft', seconds: 953 })
  expect(timeShown(20, 21)).toEqual({ key: 'timeLeft', seconds: 0 })
})

test('of a limit of hours nobody is told that 9,999 s are left, but what has passed', () => {
  expect(timeShown(10_000, 1)).toEqual({ key: 'timePassed', seconds: 1 })
})
