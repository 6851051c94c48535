import { expect, test } from 'vitest'
import { Outcome } from './outcome.svelte.ts'

const point = (round: number) => ({ round, practised: 100 - round, kept: null })
const rounds = ({ curve }: Outcome) => curve.map(({ round }) => round)

test('a curve begins with the error before the first round, and measures each round once', () => {
  const outcome = new Outcome()
  outcome.begin(false)
  outcome.measure([point(0), point(1)])
  outcome.measure([point(1), point(2)])
  outcome.measure([point(2), point(3)])
  expect(rounds(outcome)).toEqual([0, 1, 2, 3])
  expect(outcome.point).toEqual(point(0))
})
