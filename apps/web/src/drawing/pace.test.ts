import { expect, test } from 'vitest'
import { Pace } from './pace.ts'

test('a canvas is slow when half a second of paintings in a row were', () => {
  const pace = new Pace()
  const answers = Array.from({ length: 30 }, () => pace.isSlow(13))
  expect(answers).toEqual([...Array<boolean>(29).fill(false), true])
})

test('one painting that is fast enough begins the count again', () => {
  const pace = new Pace()
  for (let painted = 0; painted < 29; painted += 1) pace.isSlow(40)
  pace.isSlow(4)
  expect(pace.isSlow(40)).toBe(false)
})
