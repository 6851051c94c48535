import fc from 'fast-check'
import { expect, test } from 'vitest'
import { movedBy, placeOn, shareOf, spanOf, tickAt } from './scale.ts'

const s = 60

test('a short run has a number at every second', () => {
  const span = spanOf(0, 4.9 * s)
  expect(span.length).toBe(5 * s)
  expect(span.labels).toEqual([0, 1, 2, 3, 4, 5].map((seconds) => seconds * s))
})

test('ten minutes and a bit fit, with round numbers', () => {
  const span = spanOf(73 * s, 680 * s)
  expect(span.labels.map((tick) => tick / s)).toEqual([120, 240, 360, 480, 600, 720])
})

test('every moment that is kept lies on the slider, and there are never more than seven numbers', () => {
  const moments = fc.record({ first: fc.nat(400_000), length: fc.nat(605 * s) })
  fc.assert(
    fc.property(moments, ({ first, length }) => {
      const span = spanOf(first, first + length)
      expect(span.from + span.length).toBeGreaterThanOrEqual(first + length)
      expect(shareOf(span, first)).toBe(0)
      expect(span.labels.length).toBeLessThanOrEqual(7)
      for (const tick of span.labels) expect(tick).toBeGreaterThanOrEqual(first)
    }),
  )
})

test('the place of a moment on the slider leads back to it, whatever its width', () => {
  const moments = fc.record({ tick: fc.nat(5 * s), width: fc.integer({ min: 60, max: 2000 }) })
  fc.assert(
    fc.property(moments, ({ tick, width }) => {
      const span = spanOf(0, 4 * s)
      expect(tickAt(span, placeOn(span, tick, width), width)).toBe(tick)
    }),
  )
})

test('beyond the ends of the slider lies what is no moment of the run', () => {
  const span = spanOf(0, 4 * s)
  expect(tickAt(span, 0, 340)).toBe(-20)
  expect(tickAt(span, 340, 340)).toBe(5 * s + 20)
})

const press = (key: string, shiftKey = false) => movedBy({ key, shiftKey }, 600, { first: 0, now: 640 })

test('arrows go a tenth of a second, with Shift a whole one, pages ten; nobody leaves the run', () => {
  expect(press('ArrowLeft')).toBe(594)
  expect(press('ArrowRight', true)).toBe(640)
  expect(press('PageDown')).toBe(0)
  expect(press('Home')).toBe(0)
  expect(press('End')).toBe(640)
  expect(press('a')).toBeNull()
})
