import { isLong, sample } from '@botgarten/numbers/testing'
import type { RobotConfig } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { networkCards, seeds, solved } from './solved.ts'

// What makes a robot drive a bend comes first.
const wheels = sample<NonNullable<RobotConfig['strength']>>(
  [
    { left: 0.9, right: 1 },
    { left: 1, right: 0.9 },
    { left: 1, right: 1 },
    { left: 0.9, right: 0.9 },
    { left: 1.1, right: 1.1 },
    { left: 1.1, right: 1 },
    { left: 1, right: 1.1 },
  ],
  2,
)

// Wheels that err by 10 percent, and sensors too. At their whole length: every setting on every seed, on the first one for
// the card's whole time.
describe.each(networkCards)('the solution of %s', (id) => {
  const { card, failures, lasting } = solved(id)
  const failing = (seed: number) => (isLong && seed === seeds[0] ? failures : lasting)

  it.each(card.starts.map((_, start) => start))(
    'holds from start pose %i with unlike wheels on every seed',
    (start) => {
      const found = wheels.flatMap((strength) =>
        seeds
          .map((seed) => ({ strength, seed, checks: failing(seed)(start, seed, { strength, noise: 10 }) }))
          .filter(({ checks }) => checks.length > 0),
      )
      expect(found).toEqual([])
    },
  )
})
