import { expect, test } from 'vitest'
import { content } from '../files.ts'
import { expectTrue } from './claims.ts'

const claims = content.items.flatMap((item) => item.claims ?? [])

test('a claim on what practice comes to is refused where it is wrong by one percent', () => {
  const claim = claims.flatMap((one) => ('practises' in one && one.off ? [one] : []))[0]!
  const [[round, { practised }]] = Object.entries(claim.off!) as [[string, { practised: number }]]
  const wrong = { ...claim, off: { [round]: { practised: practised + 1 } } }
  expect(() => expectTrue({ ...claim, off: { [round]: { practised } } })).not.toThrow()
  expect(() => expectTrue(wrong)).toThrow(/to match object/)
})
