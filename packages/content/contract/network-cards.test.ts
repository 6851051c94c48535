import { isLong } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import { networkCards, seeds, solved } from './solved.ts'

// No robot is like another: solutions hold with sensors that err by 10 percent; with wheels too: unlike-wheels.test.ts.
describe.each(networkCards)('the solution of %s', (id) => {
  const { card, failures, lasting } = solved(id)
  const failing = isLong ? failures : lasting

  it.each(card.starts.map((_, start) => start))(
    'holds from start pose %i on every seed with noise',
    (start) => {
      expect(seeds.flatMap((seed) => failing(start, seed, { noise: 10 }))).toEqual([])
    },
  )
})
