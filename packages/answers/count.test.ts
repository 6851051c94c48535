import { expect, test } from 'vitest'
import { countsOf, meanOf, medianOf, sharesOf } from './count.ts'
import reference from './reference/statistics.json' with { type: 'json' }

test.each(reference.counts)('mean, median and shares of $counts are those of pandas', (given) => {
  expect(meanOf(given.counts)).toBeCloseTo(given.mean, 12)
  expect(medianOf(given.counts)).toBe(given.median)
  sharesOf(given.counts).forEach((share, at) => expect(share).toBeCloseTo(given.shares[at]!, 12))
})

test('of nobody there is no mean, no median and no share', () => {
  expect([meanOf([0, 0]), medianOf([0, 0]), sharesOf([0, 0])]).toEqual([null, null, [null, null]])
})

test('what is no option is not counted', () => {
  expect(countsOf(['yes', 'no'], ['no', 'perhaps', 'no', 'toString'])).toEqual([0, 2])
})
