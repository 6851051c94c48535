import { expect, it } from 'vitest'
import { goOn2020, study2020 } from './study-2020.ts'

// The thesis prints means of whole answers from 1 to 5, rounded or cut to two digits: each is such a mean for its group.
it('every printed mean is one of so many whole answers', () => {
  for (const { n, interest, ease } of study2020)
    for (const mean of [...Object.values(interest), ...Object.values(ease)]) {
      expect(mean >= 1 && mean <= 5).toBe(true)
      expect(Math.abs(Math.ceil(mean * n - 0.08) / n - mean)).toBeLessThan(0.01)
    }
})

it('24 children answered, and their shares of going on are shares of whole children', () => {
  expect(study2020.reduce((sum, { n }) => sum + n, 0)).toBe(24)
  for (const { n, goOn } of study2020) {
    const shares = Object.values(goOn)
    expect(shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 12)
    for (const share of shares) expect(Math.abs(share * n - Math.round(share * n))).toBeLessThan(0.01)
  }
})

it('of all 24 children 75 % would like to go on and 25 % maybe, as section 7.4.4 prints', () => {
  expect(goOn2020()).toEqual({ n: 24, yes: 0.75, maybe: 0.25, no: 0 })
})
