import fc from 'fast-check'
import { expect, test } from 'vitest'
import { addToHash, hex, startHash } from './index.ts'
import reference from './reference/hashes.json' with { type: 'json' }

const hashOf = (...values: number[]) => {
  const hash = startHash()
  for (const x of values) addToHash(hash, x)
  return hex(hash)
}

test.each(reference)(
  'FNV-1a 64 over doubles: $hash as the published algorithm gives it',
  ({ values, hash }) => {
    expect(hashOf(...values)).toBe(hash)
  },
)

test('0 and −0 are one place', () => {
  expect(hashOf(-0)).toBe(hashOf(0))
})

test('every NaN is the same NaN', () => {
  const odd = new Float64Array(new BigUint64Array([0xfff8000000000123n]).buffer)[0]!
  expect(hashOf(odd)).toBe(hashOf(NaN))
  expect(hashOf(NaN)).not.toBe(hashOf(0))
})

test('one last bit or another order gives another hash', () => {
  expect(hashOf(0.1 + 0.2)).not.toBe(hashOf(0.3))
  fc.assert(
    fc.property(fc.double({ noNaN: true }), fc.double({ noNaN: true }), (a, b) => {
      fc.pre(a !== b)
      expect(hashOf(a, b)).not.toBe(hashOf(b, a))
    }),
  )
})
