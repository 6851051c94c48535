import { expect, test } from 'vitest'
import { around, onStrip, shares, slope } from './chart.ts'

test('the middle of the middle option is where all bars meet', () => {
  const { middle, bars } = around(
    [
      [1, 4, 6, 7, 4],
      [0, 0, 4, 7, 11],
    ],
    340,
  )
  // 8 left, 20 right: 28 people are 340 px at the most.
  expect(middle).toBeCloseTo((8 / 28) * 340)
  for (const pieces of bars) {
    const half = pieces.find(({ at }) => at === 2)!
    expect(half.x + half.width / 2).toBeCloseTo(middle)
    // From left to right without a gap.
    pieces.slice(1).forEach((piece, at) => expect(piece.x).toBeCloseTo(pieces[at]!.x + pieces[at]!.width))
  }
  expect(bars[1]!.map(({ at, count }) => [at, count])).toEqual([
    [2, 4],
    [3, 7],
    [4, 11],
  ])
})

test('nobody makes no bar', () => {
  expect(around([[0, 0, 0, 0, 0]], 100).bars).toEqual([[]])
  expect(shares([0, 0], 100)).toEqual([])
})

test('shares fill the room', () => {
  const pieces = shares([14, 6, 2], 220)
  expect(pieces.map(({ width }) => Math.round(width))).toEqual([140, 60, 20])
})

test('a slope goes from moment to moment', () => {
  const room = { left: 0, right: 100, top: 0, bottom: 50 }
  const { path, places } = slope(
    [
      { at: 0, share: 0.5 },
      { at: 1, share: 1 },
    ],
    2,
    room,
  )
  expect(places.map(({ x, y }) => [x, y])).toEqual([
    [0, 25],
    [100, 0],
  ])
  expect(path).toBe('M0,25L100,0')
})

test('a mean of 3 lies in the middle of its strip', () => {
  expect(onStrip(3, 120)).toBe(60)
})

test('bars that all lie left of the middle fill the room, up to the middle at its right end', () => {
  const { middle, bars } = around([[3, 1, 0, 0, 0]], 200)
  expect(middle).toBe(200)
  // 4 people are 200 px: 3 of them 150, 1 of them 50.
  expect(bars[0]!.map(({ x, width }) => [x, width])).toEqual([
    [0, 150],
    [150, 50],
  ])
})
