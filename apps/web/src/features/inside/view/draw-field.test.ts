import fc from 'fast-check'
import { expect, test } from 'vitest'
import { arrowOf, drawField, headOf } from './draw-field.ts'

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

const drawn = {
  poses: [
    { x: 10, y: 10, heading: 0 },
    { x: 30, y: 10, heading: 0 },
    { x: 90, y: 10, heading: 0 },
  ],
  inputs: [],
  spacing: 12,
  answers: [[80, 80], null, [80, 80]],
  wheels: { left: 0, right: 1 },
  colours: [{ colour: '#111111' }, { colour: '#222222' }],
  floor: { width: 100, height: 100 },
  scale: 2,
  window: { left: 0, top: 0, width: 100, height: 200 },
}

test('arrows stand where Bo has room and somebody looks, an arrow and its head a place', () => {
  const [lines, dots] = drawField(drawn).shapes
  if (lines?.kind !== 'lines' || dots?.kind !== 'lines') throw new Error('no lines')
  const gaps = (points: Float32Array) => points.filter(Number.isNaN).length / 2
  expect(gaps(lines.points)).toBe(1)
  expect([...dots.points]).toEqual([20, 180, 20, 180])
})

test('a network that does not drive has a disc in the colour of its strongest output', () => {
  const wheels = { left: -1, right: -1 }
  expect(drawField({ ...drawn, wheels, answers: [[20, 80], [0, 0], null] }).shapes).toMatchObject([
    { kind: 'circle', x: 20, y: 180, fill: '#222222', stroke: '#4A3428' },
    { kind: 'circle', x: 60, y: 180, r: 1.5, fill: '#4A3428' },
  ])
})
