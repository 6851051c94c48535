import fc from 'fast-check'
import { beforeEach, expect, test } from 'vitest'
import { Limits } from './limits.ts'
import { Refusal } from './refusal.ts'

let now: number
let limits: Limits
beforeEach(() => {
  now = 1000
  limits = new Limits(() => now)
})

const refusal = (act: () => unknown) => {
  try {
    act()
    return null
  } catch (error) {
    if (!(error instanceof Refusal)) throw error
    return { status: error.status, code: error.code, ...error.facts }
  }
}

test('after 300 requests at once a pupil gets 30 a second, and each refusal names the seconds to wait', () => {
  for (let count = 0; count < 300; count++) limits.request('fox')
  expect(refusal(() => limits.request('fox'))).toEqual({ status: 429, code: 'tooFast', seconds: 1 })
  now += 1000
  for (let count = 0; count < 30; count++) limits.request('fox')
  expect(refusal(() => limits.request('fox'))).toMatchObject({ code: 'tooFast' })
})

test('one pupil at her limit takes nothing from another', () => {
  for (let count = 0; count < 300; count++) limits.request('fox')
  expect(refusal(() => limits.request('owl'))).toBeNull()
})

test('a pupil has eight streams at most; one that has ended makes room', () => {
  const ends = Array.from({ length: 8 }, () => limits.stream('fox'))
  now += 10_000
  expect(refusal(() => limits.stream('fox'))).toEqual({ status: 429, code: 'tooManyStreams', seconds: 60 })
  ends[0]!()
  expect(refusal(() => limits.stream('fox'))).toBeNull()
})

test('a pupil sends two of the largest projects at once; one alone always goes, however large', () => {
  const first = limits.upload('fox', 5_000_000)
  limits.upload('fox', 5_000_000)
  expect(refusal(() => limits.upload('fox', 1))).toEqual({ status: 429, code: 'tooMuchAtOnce', seconds: 2 })
  expect(refusal(() => limits.upload('owl', 5_000_000))).toBeNull()
  first()
  expect(refusal(() => limits.upload('fox', 1))).toBeNull()
  expect(refusal(() => limits.upload('badger', 50_000_000))).toBeNull()
})

test('property: in any time a pupil gets at most 300 requests and 30 more each second', () => {
  fc.assert(
    fc.property(fc.array(fc.tuple(fc.nat(2000), fc.nat(400)), { maxLength: 30 }), (steps) => {
      const own = new Limits(() => now)
      const began = now
      let answered = 0
      for (const [pause, requests] of steps) {
        now += pause
        for (let count = 0; count < requests; count++)
          if (refusal(() => own.request('fox')) === null) answered++
      }
      expect(answered).toBeLessThanOrEqual(300 + ((now - began) / 1000) * 30)
    }),
    { numRuns: 20 },
  )
})

test('ten thousand pupils later the buckets of those who left are gone, and those of open streams are not', () => {
  const end = limits.stream('fox')
  for (let count = 0; count < 9_999; count++) limits.request(`pupil ${count}`)
  now += 60_000
  limits.request('one more')
  expect(limits.size).toBe(2)
  end()
})
