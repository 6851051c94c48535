import fc from 'fast-check'
import { expect, test } from 'vitest'
import { surplus } from './retention.ts'

const hour = 3_600_000
const numbered = (times: readonly number[]) => times.map((savedAt, at) => ({ revision: at + 1, savedAt }))

test('twenty versions all stay', () => {
  expect(surplus(numbered(Array<number>(20).fill(0)), 0)).toEqual([])
})

test('of a day of saves every five minutes the last 20 and one of each hour stay', () => {
  const versions = numbered(Array.from({ length: 12 * 30 }, (_, at) => at * (hour / 12)))
  const now = versions.at(-1)!.savedAt
  const gone = new Set(surplus(versions, now))
  const left = versions.filter(({ revision }) => !gone.has(revision))
  // The last 20 reach into the hour before the last; of the 24 hours before now each keeps its newest.
  expect(left.filter(({ revision }) => revision > 340)).toHaveLength(20)
  expect(left.filter(({ revision }) => revision <= 340).map(({ revision }) => revision)).toEqual(
    Array.from({ length: 22 }, (_, at) => 12 * (7 + at)),
  )
})

test('the newest version never goes, whatever the clock said', () =>
  fc.assert(
    fc.property(
      fc.array(fc.integer({ min: 0, max: 60 * hour }), { minLength: 1, maxLength: 80 }),
      fc.nat(60 * hour),
      (times, now) => {
        const versions = numbered(times)
        const gone = surplus(versions, now)
        expect(gone).not.toContain(versions.length)
        expect(gone.length).toBeLessThanOrEqual(Math.max(0, versions.length - 20))
      },
    ),
  ))
