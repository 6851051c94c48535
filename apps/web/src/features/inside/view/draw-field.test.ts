import fc from 'fast-check'
import { expect, test } from 'vitest'
import { arrowOf, headOf } from './draw-field.ts'

const pose = { x: 50, y: 40, heading: 90 }
const tip = (left: number, right: number) => arrowOf(pose, left, right, 12).at(-1)!

test('an arrow points where the robot would go: ahead, back, left, right', () => {
  expect(tip(80, 80).x).toBeCloseTo(50, 9)
  expect(tip(80, 80).y).toBeGreaterThan(46)
  expect(tip(-80, -80).y).toBeLessThan(34)
  expect(tip(20, 80).x).toBeLessThan(49)
  expect(tip(80, 20).x).toBeGreaterThan(51)
})

test('a robot that turns on the spot has an arrow round its middle, and one that stands has none', () => {
  const points = arrowOf(pose, -100, 100, 12).slice(1)
  for (const { x, y } of points) expect(Math.hypot(x - 50, y - 40)).toBeCloseTo(3.6, 9)
  expect(points.at(-1)!.x).toBeLessThan(points[0]!.x)
  expect(arrowOf(pose, 0, 0, 12)).toEqual([])
  expect(arrowOf(pose, 0.2, -0.3, 12)).toEqual([])
})

test('no arrow reaches its neighbour, however fast the wheels are told to be', () => {
  const speed = fc.integer({ min: -400, max: 400 })
  fc.assert(
    fc.property(speed, speed, fc.integer({ min: 0, max: 359 }), (left, right, heading) => {
      for (const { x, y } of arrowOf({ ...pose, heading }, left, right, 12))
        expect(Math.hypot(x - 50, y - 40)).toBeLessThan(12)
    }),
    { seed: 7 },
  )
})

test('a head lies behind its tip, on both sides', () => {
  const [one, other] = headOf(
    [
      { x: 0, y: 0 },
      { x: 10, y: 0 },
    ],
    3,
  )
  expect(one.x).toBeLessThan(10)
  expect(one.y).toBeCloseTo(-other.y, 9)
  expect(Math.abs(one.y)).toBeGreaterThan(1)
})
