import fc from 'fast-check'
import { expect, test } from 'vitest'
import { nudged, padOf, wayAhead, wheelsOfPad } from './pad.ts'

test('straight up is both wheels at full, and the middle is still, also for a hand that trembles', () => {
  expect(wheelsOfPad(0, 1)).toEqual({ left: 100, right: 100 })
  expect(wheelsOfPad(0.05, -0.07)).toEqual({ left: 0, right: 0 })
  expect(wheelsOfPad(0.05, 0.5)).toEqual({ left: 50, right: 50 })
})

test('to the right the left wheel is the faster one, and nothing goes beyond 100', () => {
  expect(wheelsOfPad(0.3, 0.6)).toEqual({ left: 90, right: 30 })
  expect(wheelsOfPad(0.8, 0.9)).toEqual({ left: 100, right: 10 })
})

test('the knob of the pad stands where its wheels are', () => {
  const part = fc.double({ min: -0.5, max: 0.5, noNaN: true })
  fc.assert(
    fc.property(part, part, (x, y) => {
      const wheels = wheelsOfPad(x, y)
      const at = padOf(wheels)
      expect(wheelsOfPad(at.x, at.y)).toEqual(wheels)
    }),
    { seed: 4 },
  )
})

test('arrow keys push the pad, and other keys do not', () => {
  expect(nudged({ left: 95, right: 40 }, 'ArrowUp')).toEqual({ left: 100, right: 50 })
  expect(nudged({ left: 0, right: 0 }, 'ArrowLeft')).toEqual({ left: -10, right: 10 })
  expect(nudged({ left: 0, right: 0 }, 'a')).toBeNull()
})

const bo = { wheelDiameter: 5.6, trackWidth: 18 }

test('at full speed Bo goes four wheel turns in two seconds', () => {
  const way = wayAhead({ x: 0, y: 0, heading: 90 }, { left: 100, right: 100 }, bo)
  expect(way.at(-1)!.y).toBeCloseTo(4 * Math.PI * 5.6, 6)
  expect(way.at(-1)!.x).toBeCloseTo(0, 6)
})

test('with one wheel against the other Bo turns on the spot', () => {
  const way = wayAhead({ x: 5, y: 7, heading: 0 }, { left: -40, right: 40 }, bo)
  expect(way.at(-1)).toEqual({ x: 5, y: 7 })
})
