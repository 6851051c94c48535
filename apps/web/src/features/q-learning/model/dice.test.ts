import fc from 'fast-check'
import { expect, test } from 'vitest'
import { pinnedSeed, seedLink, throwSeed } from './dice.ts'

test('a device throws a seed from 1 to 99,999, and one device another than the next', () => {
  fc.assert(
    fc.property(fc.integer({ min: 0, max: 2 ** 32 - 1 }), (random) => {
      const seed = throwSeed(random)
      expect(seed).toBeGreaterThanOrEqual(1)
      expect(seed).toBeLessThanOrEqual(99_999)
    }),
  )
  expect(new Set(Array.from({ length: 20 }, () => throwSeed())).size).toBeGreaterThan(15)
})

test('a link pins the seed, and following it throws the same dice', () => {
  fc.assert(
    fc.property(fc.integer({ min: 1, max: 999_999_999 }), (seed) => {
      const link = seedLink({ origin: 'https://lab.example', pathname: '/lab/railway' }, seed)
      expect(pinnedSeed(new URL(link).search)).toBe(seed)
    }),
  )
})

test('an address that pins nothing, or nonsense, leaves the dice to the device', () => {
  for (const search of ['', '?dice=', '?dice=0', '?dice=-3', '?dice=1e5', '?dice=99999999999', '?p=x'])
    expect(pinnedSeed(search)).toBeNull()
})
