import fc from 'fast-check'
import { expect, test } from 'vitest'
import { afterAnswer, afterCheck, neverRun, type Clock, type RunningDays } from './running-days.ts'

const daysAfter = (day: string, count: number) =>
  new Date(Date.parse(day) + count * 86_400_000).toISOString().slice(0, 10)
const clockAt =
  (today: string): Clock =>
  (offset) =>
    daysAfter(today, offset)

const start = '2027-03-01'
const day = (offset: number) => daysAfter(start, offset)
const at = (offset: number) => clockAt(day(offset))
const ran: RunningDays = { last: start, doubt: null }
const checks = (state: RunningDays, offsets: readonly number[]) =>
  offsets.reduce((before, offset) => afterCheck(before, at(offset)), state)

test.each([
  ['the same day', 0, false],
  ['7 days later', 7, false],
  ['8 days later', 8, true],
  ['a day before', -1, true],
  ['a year later', 365, true],
])('the clock shows %s (%i days): doubted %s', (_, offset, isDoubted) => {
  expect(afterCheck(ran, at(offset)).doubt !== null).toBe(isDoubted)
})

test('a server that never ran believes its clock, unless it shows a day before this program was written', () => {
  expect(afterCheck(neverRun, at(0))).toEqual({ last: start, doubt: null })
  const early = afterCheck(neverRun, clockAt('1970-01-01'))
  expect(early).toMatchObject({ last: null, doubt: { days: [] } })
  expect(afterCheck(early, at(0))).toEqual({ last: start, doubt: null })
})

test('without an answer the clock is believed on the 14th different day of running', () => {
  const thirteen = Array.from({ length: 13 }, (_, index) => 100 + 3 * index)
  const state = checks(ran, [...thirteen, ...thirteen.slice(-1)])
  expect(state.doubt?.days).toHaveLength(13)
  expect(afterCheck(state, at(140))).toEqual({ last: day(140), doubt: null })
})

test('days before the last day of running, or more than a year after it, never count', () => {
  const many = Array.from({ length: 40 }, (_, index) => index)
  expect(
    checks(
      ran,
      many.map((index) => -50 + index),
    ).doubt?.days,
  ).toEqual([])
  expect(
    checks(
      ran,
      many.map((index) => 366 + index),
    ).doubt?.days,
  ).toEqual([])
})

test('days that a clock set back now calls later do not count', () => {
  const state = checks(ran, [100, 101, 102, 50])
  expect(state.doubt?.days).toEqual([day(50)])
})

test('a clock that is set right again is believed', () => {
  expect(checks(ran, [300, 301, 2])).toEqual({ last: day(2), doubt: null })
})

test('the operator says that it is right: it is believed from this day on', () => {
  expect(afterAnswer(checks(ran, [50]), at(50), true)).toEqual({ last: day(50), doubt: null })
})

test('the operator says that it is wrong: that holds until the clock jumps', () => {
  const denied = afterAnswer(checks(ran, [300]), at(300), false)
  expect(denied.doubt?.denied).toBe(true)
  const later = checks(
    denied,
    Array.from({ length: 30 }, (_, index) => 301 + index),
  )
  expect(later).toMatchObject({ last: start, doubt: { denied: true } })
  for (const jump of [20, 345]) expect(afterCheck(later, at(jump)).doubt?.denied).toBe(false)
  expect(afterCheck(later, at(5))).toEqual({ last: day(5), doubt: null })
})

test('an answer without a question changes nothing', () => {
  for (const isRight of [true, false]) expect(afterAnswer(ran, at(0), isRight)).toBe(ran)
})

const offset = fc.oneof(fc.integer({ min: -800, max: 800 }), fc.integer({ min: -3, max: 40 }))

test('without an answer the clock is never believed before 14 different days that may be right', () => {
  fc.assert(
    fc.property(fc.array(offset, { maxLength: 60 }), (offsets) => {
      let state = ran
      let inDoubt = new Set<string>()
      for (const one of offsets) {
        const [last, today] = [state.last!, day(one)]
        const wasDoubted = state.doubt !== null
        state = afterCheck(state, at(one))
        if (!wasDoubted) inDoubt = new Set()
        inDoubt.add(today)
        if (state.doubt !== null) continue
        // Believed: it follows the last day of running, or there were enough different days within a year of it.
        expect(today >= last).toBe(true)
        if (today > daysAfter(last, 7)) {
          expect(today <= daysAfter(last, 365)).toBe(true)
          expect([...inDoubt].filter((seen) => seen >= last && seen <= today).length).toBeGreaterThanOrEqual(
            14,
          )
        }
      }
    }),
  )
})

test('a second check on the same day changes nothing', () => {
  fc.assert(
    fc.property(fc.array(offset, { maxLength: 30 }), (offsets) => {
      let state = ran
      for (const one of offsets) {
        state = afterCheck(state, at(one))
        expect(afterCheck(state, at(one))).toEqual(state)
      }
    }),
  )
})

test('whatever the clock showed, days of running from then on end a doubt within 14, if they are within a year', () => {
  fc.assert(
    fc.property(fc.array(offset, { maxLength: 30 }), (offsets) => {
      let state = checks(ran, offsets)
      const from = state.last!
      for (let index = 0; index < 14 && state.doubt; index++)
        state = afterCheck(state, clockAt(daysAfter(from, 300 + index)))
      expect(state.doubt).toBeNull()
    }),
  )
})
