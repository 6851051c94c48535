import fc from 'fast-check'
import { expect, test } from 'vitest'
import { apart, fieldIn, hullOf, spotOf, under, type Spot, stepByKey } from './geometry.ts'

const room = fc.record({
  width: fc.integer({ min: 300, max: 2000 }),
  height: fc.integer({ min: 250, max: 1200 }),
})
const value = fc.double({ min: 0, max: 10, noNaN: true })

test('from the plane to the screen and back is the same place', () => {
  fc.assert(
    fc.property(room, value, value, (size, x, y) => {
      const field = fieldIn(size)
      expect(field.valueX(field.x(x))).toBeCloseTo(x, 9)
      expect(field.valueY(field.y(y))).toBeCloseTo(y, 9)
    }),
  )
})

test('what a finger lets go outside stays on the plane', () => {
  const field = fieldIn({ width: 700, height: 500 })
  expect(field.valueX(-100)).toBe(0)
  expect(field.valueY(-100)).toBe(10)
})

test('the plane ends inside its room, with a margin for the axes below it and on its left', () => {
  fc.assert(
    fc.property(room, (size) => {
      const field = fieldIn(size)
      const [right, below] = [size.width - field.left - field.width, size.height - field.top - field.height]
      expect(Math.min(right, below, field.top, field.left)).toBeGreaterThan(0)
      expect([field.left, below]).toEqual([46, 46])
    }),
  )
})

test('things on one place move apart, each once', () => {
  const spots = apart(
    Array.from({ length: 12 }, () => ({ x: 100, y: 100 })),
    40,
    { left: 0, top: 0, width: 400, height: 400 },
  )
  expect(spots[0]).toEqual({ x: 100, y: 100 })
  spots.forEach((a, index) =>
    spots
      .slice(index + 1)
      .forEach((b) => expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeGreaterThanOrEqual(37.9)),
  )
})

test('on the smallest plane twelve things each have 44 px for a finger, and all stay on it', () => {
  const small = fieldIn({ width: 299, height: 295 })
  const spots = apart(
    Array.from({ length: 12 }, () => ({ x: small.x(10), y: small.y(10) })),
    47,
    small,
  )
  spots.forEach((a, index) => {
    expect(a.x).toBeGreaterThanOrEqual(small.left)
    expect(a.x).toBeLessThanOrEqual(small.left + small.width)
    expect(a.y).toBeGreaterThanOrEqual(small.top)
    expect(a.y).toBeLessThanOrEqual(small.top + small.height)
    spots.slice(index + 1).forEach((b) => expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeGreaterThanOrEqual(44))
  })
})

test('without a column things lie in the middle of that axis', () => {
  const field = fieldIn({ width: 700, height: 500 })
  expect(spotOf(field, [10], [0, -1])).toEqual({ x: field.x(10), y: field.y(5) })
})

test('a finger takes the nearest spot within reach, or none', () => {
  const spots = [
    { x: 0, y: 0 },
    { x: 10, y: 0 },
  ]
  expect(under(spots, 6, 0, 20)).toBe(1)
  expect(under(spots, 60, 0, 20)).toBeNull()
})

const spots = fc.array(
  fc.record({ x: fc.integer({ min: 0, max: 50 }), y: fc.integer({ min: 0, max: 50 }) }),
  {
    minLength: 3,
    maxLength: 40,
  },
)
const left = (a: Spot, b: Spot, c: Spot) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)

test('a hull has every spot on its left side or on it', () => {
  fc.assert(
    fc.property(spots, (all) => {
      const hull = hullOf(all)
      hull.forEach((from, index) => {
        const to = hull[(index + 1) % hull.length]!
        for (const spot of all) expect(left(from, to, spot)).toBeGreaterThanOrEqual(0)
      })
    }),
  )
})

test('of a square with a spot inside it is the square', () => {
  const square = [
    { x: 0, y: 0 },
    { x: 4, y: 0 },
    { x: 4, y: 4 },
    { x: 0, y: 4 },
  ]
  expect(hullOf([...square, { x: 2, y: 2 }])).toEqual(square)
})

test('of the smallest triangle has all three corners', () => {
  const triangle = [
    { x: 0, y: 0 },
    { x: 1, y: 0 },
    { x: 0, y: 1 },
  ]
  expect(hullOf(triangle)).toEqual(triangle)
})

test('arrow keys move a flag in small or large steps, other keys do not', () => {
  expect([stepByKey('ArrowLeft', false), stepByKey('ArrowDown', true)]).toEqual([
    { x: -10, y: 0 },
    { x: 0, y: 40 },
  ])
  expect(stepByKey('Home', false)).toBeNull()
})
