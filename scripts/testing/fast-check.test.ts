import fc from 'fast-check'
import { expect, test } from 'vitest'
import { isLong } from '@botgarten/numbers/testing'

test('the same cases are tried on every run, but in the long form', () => {
  const draw = () => JSON.stringify(fc.sample(fc.integer(), 5))
  expect(draw() === draw()).toBe(!isLong || process.env['BOTGARTEN_SEED'] !== undefined)
})
