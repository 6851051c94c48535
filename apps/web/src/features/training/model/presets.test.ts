import { expect, test } from 'vitest'
import { batches, decays, momenta, paces, rates, roundChoices } from './presets.ts'

test.each([
  ['rates', rates],
  ['rounds', roundChoices],
  ['batches', batches],
  ['momenta', momenta],
  ['decays', decays],
  ['paces', paces],
])('the %s to choose from grow, so that a child can say more or less', (_name, choices) => {
  expect(choices).toEqual([...choices].sort((a, b) => a - b))
  expect(new Set(choices).size).toBe(choices.length)
})

test('at the slowest pace each round is seen for one second', () => {
  expect(1 / paces[0]).toBe(1)
})
