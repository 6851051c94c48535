import { expect, test } from 'vitest'
import { momentOf } from './records.ts'

test.each([
  // ECMA-262, 21.4.1.1: the last moment that a Date can hold.
  [8.64e15, 8.64e15],
  [8.64e15 + 1, 0],
  [0, 0],
  [-1, 0],
  [NaN, 0],
  ['1', 0],
  [undefined, 0],
])('the moment %j of a record counts as %d', (value, moment) => {
  expect(momentOf(value)).toBe(moment)
})
