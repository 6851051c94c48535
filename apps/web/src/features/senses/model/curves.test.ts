import fc from 'fast-check'
import { expect, test } from 'vitest'
import { curvesOf, paper, roundUp } from './curves.ts'

test('pay is a line over whole minutes, bumps are bars with their numbers', () => {
  const drawn = curvesOf([{ pay: 90, bumps: 7 }, { pay: 165, bumps: 5 }], 8) // prettier-ignore
  expect(drawn.minutes.map(({ minute }) => minute)).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
  expect(drawn.pays.map(({ value }) => value)).toEqual([0, 100, 200])
  expect(drawn.dots.map(({ minute }) => minute)).toEqual([1, 2])
  expect(drawn.dots[1]!.y).toBeLessThan(drawn.dots[0]!.y)
  expect(drawn.bars[0]!.height).toBeGreaterThan(drawn.bars[1]!.height)
  expect(drawn.named).toBe(true)
})

test('pay below 0 has its place, and an hour of minutes is not named one by one', () => {
  const drawn = curvesOf([{ pay: -240, bumps: 0 }], 60)
  expect(drawn.pays[0]!.value).toBeLessThanOrEqual(-240)
  expect(drawn.zero).toBeLessThan(drawn.bottom)
  expect(drawn.minutes.length).toBeLessThanOrEqual(13)
  expect(drawn.named).toBe(false)
})

test('everything lies on the paper', () => {
  const minute = fc.record({
    pay: fc.double({ min: -1e6, max: 1e6, noNaN: true }),
    bumps: fc.nat({ max: 240 }),
  })
  fc.assert(
    fc.property(fc.array(minute, { maxLength: 60 }), fc.integer({ min: 1, max: 60 }), (curve, most) => {
      const { dots, bars, minutes, pays } = curvesOf(curve, most)
      const all = [
        ...[...dots, ...pays].map(({ y }) => y / paper.height),
        ...[...dots, ...minutes].map(({ x }) => x / paper.width),
        ...bars.flatMap(({ x, y, width }) => [x / paper.width, (x + width) / paper.width, y / paper.height]),
      ]
      for (const share of all) expect(share >= 0 && share <= 1).toBe(true)
    }),
  )
})

test('an axis goes up to a round number', () => {
  expect([0, 3, 45, 100, 101].map(roundUp)).toEqual([1, 5, 50, 100, 200])
})
