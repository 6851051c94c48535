import { expect, test } from 'vitest'
import { countMissed } from './at-work.svelte.ts'

test('runs that miss the same check in a row are counted, and another check begins again', () => {
  const first = countMissed(null, 'near')
  expect(first).toEqual({ check: 'near', times: 1 })
  const third = countMissed(countMissed(first, 'near'), 'near')
  expect(third).toEqual({ check: 'near', times: 3 })
  expect(countMissed(third, 'stays')).toEqual({ check: 'stays', times: 1 })
})
