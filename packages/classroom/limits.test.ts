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

const fox = { id: 'fox', class: '5b' }
const owl = { id: 'owl', class: '5b' }
const badger = { id: 'badger', class: '5b' }
/** A pupil of another class. */
const hare = { id: 'hare', class: '6a' }
/** Pupils of class 5b. */
const many = (count: number) => Array.from({ length: count }, (_, at) => ({ id: `pupil ${at}`, class: '5b' }))

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
  const ends = Array.from({ length: 8 }, () => limits.stream(fox))
  now += 10_000
  expect(refusal(() => limits.stream(fox))).toEqual({ status: 429, code: 'tooManyStreams', seconds: 60 })
  ends[0]!()
  ends[0]!()
  expect(refusal(() => limits.stream(fox))).toBeNull()
  now += 10_000
  expect(refusal(() => limits.stream(fox))).toMatchObject({ code: 'tooManyStreams' })
})

test('a class has 200 streams at most; another class has its own', () => {
  // 25 pupils with eight each.
  for (const pupil of many(25)) for (let count = 0; count < 8; count++) limits.stream(pupil)
  expect(refusal(() => limits.stream(fox))).toEqual({ status: 429, code: 'tooManyStreams', seconds: 60 })
  expect(refusal(() => limits.stream(hare))).toBeNull()
})

test('a pupil sends two of the largest projects at once; one alone always goes, however large', () => {
  const first = limits.upload(fox, 5_000_000)
  limits.upload(fox, 5_000_000)
  expect(refusal(() => limits.upload(fox, 1))).toEqual({ status: 429, code: 'tooMuchAtOnce', seconds: 2 })
  expect(refusal(() => limits.upload(owl, 5_000_000))).toBeNull()
  first()
  expect(refusal(() => limits.upload(fox, 1))).toBeNull()
  expect(refusal(() => limits.upload(badger, 50_000_000))).toBeNull()
})

test('a class sends eight of the largest projects at once; another class sends its own', () => {
  const ends = many(8).map((pupil) => limits.upload(pupil, 5_000_000))
  expect(refusal(() => limits.upload(fox, 1))).toEqual({ status: 429, code: 'tooMuchAtOnce', seconds: 2 })
  expect(refusal(() => limits.upload(hare, 5_000_000))).toBeNull()
  ends[0]!()
  expect(refusal(() => limits.upload(fox, 5_000_000))).toBeNull()
})

test('one after the other a pupil sends 10 MB of projects and 1 MB more every four seconds', () => {
  const send = () => {
    const end = limits.upload(fox, 5_000_000)
    limits.sent('fox', 5_000_000)
    end()
  }
  for (let count = 0; count < 2; count++) send()
  expect(refusal(send)).toEqual({ status: 429, code: 'tooMuchAtOnce', seconds: 1 })
  expect(refusal(() => limits.upload(owl, 5_000_000))).toBeNull()
  now += 1000
  // The next one is accepted, and the wait comes after it.
  expect(refusal(send)).toBeNull()
  expect(refusal(send)).toMatchObject({ seconds: 20 })
  now += 19_000
  expect(refusal(send)).toMatchObject({ seconds: 1 })
  now += 1000
  expect(refusal(send)).toBeNull()
})

test('an upload that was refused counts for nothing', () => {
  for (let count = 0; count < 11; count++) refusal(() => limits.upload(fox, 5_000_000))
  // Of 40 MB of the class 30 are left for others.
  for (const pupil of many(6)) expect(refusal(() => limits.upload(pupil, 5_000_000))).toBeNull()
  expect(refusal(() => limits.upload(owl, 1))).toMatchObject({ code: 'tooMuchAtOnce' })
})

test('after 2,000 requests at once a class gets 200 a second, and another class is not slowed', () => {
  const pupils = many(10)
  for (let count = 0; count < 200; count++) for (const pupil of pupils) limits.requestOf(pupil)
  expect(refusal(() => limits.requestOf(owl))).toEqual({ status: 429, code: 'classTooFast', seconds: 1 })
  expect(refusal(() => limits.requestOf(hare))).toBeNull()
  now += 1000
  for (let count = 0; count < 20; count++) for (const pupil of pupils) limits.requestOf(pupil)
  expect(refusal(() => limits.requestOf(owl))).toMatchObject({ code: 'classTooFast' })
})

test.each([
  [30, 'hearts', 'tooManyHearts'],
  [20, 'raised or lowered hands', 'tooManyHands'],
] as const)('a pupil has %i %s at once, and one more every two seconds', (atOnce, _, code) => {
  const act = (pupil: string) => (code === 'tooManyHearts' ? limits.heart(pupil) : limits.hand(pupil))
  for (let count = 0; count < atOnce; count++) act('fox')
  expect(refusal(() => act('fox'))).toEqual({ status: 429, code, seconds: 2 })
  expect(refusal(() => act('owl'))).toBeNull()
  now += 2000
  expect(refusal(() => act('fox'))).toBeNull()
  expect(refusal(() => act('fox'))).toMatchObject({ code })
})

test('a device that was refused for its many requests is refused at once until its time is over', () => {
  limits.noteRefused('token', 2)
  expect(refusal(() => limits.refuseEarly('token'))).toEqual({ status: 429, code: 'tooFast', seconds: 2 })
  expect(refusal(() => limits.refuseEarly('another'))).toBeNull()
  expect(refusal(() => limits.refuseEarly(null))).toBeNull()
  now += 2000
  expect(refusal(() => limits.refuseEarly('token'))).toBeNull()
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

test('ten thousand pupils later the buckets of those who left are gone, and open streams are still counted', () => {
  const ends = Array.from({ length: 8 }, () => limits.stream(fox))
  for (let count = 0; count < 9_999; count++) limits.request(`pupil ${count}`)
  now += 60_000
  limits.request('one more')
  expect(limits.size).toBe(1)
  expect(refusal(() => limits.stream(fox))).toMatchObject({ code: 'tooManyStreams' })
  ends[0]!()
  expect(refusal(() => limits.stream(fox))).toBeNull()
})

test('of an upload that was refused because its pupil sent too much, nothing counts for the class', () => {
  for (let count = 0; count < 2; count++) limits.sent('fox', 5_000_000)
  for (let count = 0; count < 11; count++)
    expect(refusal(() => limits.upload(fox, 5_000_000))).toMatchObject({ code: 'tooMuchAtOnce' })
  // All 40 MB of the class are left for others.
  for (const pupil of many(8)) expect(refusal(() => limits.upload(pupil, 5_000_000))).toBeNull()
})
