import { expect, test } from 'vitest'
import { gapOf } from './gap.ts'

const from = { x: 10, y: 20 }

test('an arrow to a missed place says its length, whatever else the check counts', () => {
  const { label } = gapOf({ gap: { from, to: { x: 40, y: 60 } } })!
  expect(label).toMatch(/^50.cm$/)
})

test('a miss that names no point has no arrow', () => {
  expect(gapOf({})).toBeNull()
})
