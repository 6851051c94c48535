import type { Band, LaneResult } from '@botgarten/experiments/race'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { apart, labelsThatFit, lineOf, marksAt, scaleOf, ticksOf, timesOf } from './chart.ts'

const flat = (value: number): Band => ({ low: value, middle: value, high: value })
const laneWith = (...values: number[]): LaneResult => ({
  ...{ runs: 1, ways: [] },
  curves: { falls: values.map(flat), moves: [], stars: [], pace: [] },
  bill: { tries: 1, moves: 0, stars: 0, falls: 0, first: null, found: 0, reaches: null },
})

test('who would press all others flat leaves the picture', () => {
  const lanes = [laneWith(1, 46), laneWith(2, 30), laneWith(40, 8234)]
  expect(scaleOf(lanes, 'falls')).toEqual({ low: 0, high: 46, outside: [2] })
  expect(scaleOf(lanes.slice(0, 2), 'falls').outside).toEqual([])
})

test('the picture has room for everyone who is alike, and for what is less than nothing', () => {
  expect(scaleOf([laneWith(-10, -200), laneWith(-5, -100)], 'falls')).toEqual({
    low: -200,
    high: 1,
    outside: [],
  })
  expect(scaleOf([laneWith(0), laneWith(0)], 'falls')).toEqual({ low: 0, high: 1, outside: [] })
})

test('a lane alone has the whole picture, and one with four times as much as the next stays in it', () => {
  expect(scaleOf([laneWith(1, 46)], 'falls')).toEqual({ low: 0, high: 46, outside: [] })
  expect(scaleOf([laneWith(10), laneWith(40)], 'falls')).toEqual({ low: 0, high: 40, outside: [] })
  expect(scaleOf([laneWith(10), laneWith(41)], 'falls')).toEqual({ low: 0, high: 10, outside: [1] })
})

test('steps between ticks are 1, 2 or 5 times a power of ten, a third of the picture at least', () => {
  expect(ticksOf(0, 30)).toEqual([0, 10, 20, 30])
  expect(ticksOf(0, 31)).toEqual([0, 20])
  expect(ticksOf(0, 150)).toEqual([0, 50, 100, 150])
  expect(ticksOf(0, 3)).toEqual([0, 1, 2, 3])
})

test('ticks are round, within the picture, and not many', () => {
  expect(ticksOf(0, 60)).toEqual([0, 20, 40, 60])
  fc.assert(
    fc.property(fc.integer({ min: -1e6, max: 0 }), fc.integer({ min: 1, max: 1e6 }), (low, high) => {
      const ticks = ticksOf(low, high)
      expect(ticks.length).toBeGreaterThanOrEqual(1)
      expect(ticks.length).toBeLessThanOrEqual(5)
      for (const tick of ticks) expect(tick >= low && tick <= high).toBe(true)
    }),
  )
})

test('labels keep their order and are never nearer than their height', () => {
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 0, max: 300 }), { minLength: 1, maxLength: 8 }), (wanted) => {
      const sorted = apart(wanted, 19).toSorted((a, b) => a - b)
      sorted.slice(1).forEach((y, index) => expect(y - sorted[index]!).toBeGreaterThanOrEqual(19))
    }),
  )
})

test('a line goes through the middle of every band', () => {
  const paper = { x: (at: number) => 10 * at, y: (value: number) => 100 - value }
  expect(lineOf([flat(0), flat(20)], paper)).toBe('M0.0 100.0L10.0 80.0')
})

test('a race of one try or of three names no point twice', () => {
  expect([0, 2, 99].map(marksAt)).toEqual([[0], [1], [30, 64]])
  expect(timesOf([1])).toEqual([0])
  expect(timesOf([1, 2, 3])).toEqual([0, 1, 2])
  expect(timesOf(Array.from({ length: 100 }, (_, at) => at + 1))).toEqual([0, 24, 49, 74, 99])
})

test('on a narrow screen no label of a time lies over another', () => {
  const width = (point: number) => (point === 0 ? 70 : 26)
  const shownOn = (paper: number) =>
    labelsThatFit([0, 24, 49, 74, 99], (point) => (point / 99) * paper, width)
  expect(shownOn(700)).toEqual([0, 24, 49, 74, 99])
  expect(shownOn(95)).toEqual([0, 99])
  fc.assert(
    fc.property(fc.integer({ min: 60, max: 900 }), (paper) => {
      const x = (point: number) => (point / 99) * paper
      const shown = shownOn(paper)
      expect([shown[0], shown.at(-1)]).toEqual([0, 99])
      for (const [index, point] of shown.slice(1).entries())
        expect(x(point) - width(point) / 2).toBeGreaterThan(x(shown[index]!) + width(shown[index]!) / 2)
    }),
  )
})
