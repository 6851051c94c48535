import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { conePolygon, labelPlaces, nearestBeam, readingOf, type Beam } from './rays.ts'

const from = { x: 0, y: 0 }
const beam = (x: number, y: number): Beam => ({ from, to: { x, y }, distance: Math.hypot(x, y) })

describe('a cone', () => {
  test('goes from the sensor to the ends of its rays in order, whatever order they come in', () => {
    const ends = [beam(100, 0), beam(90, 20), beam(90, -20), beam(70, 50), beam(70, -50)]
    const inOrder = [from, ends[4]!.to, ends[2]!.to, ends[0]!.to, ends[1]!.to, ends[3]!.to]
    expect(conePolygon(ends)).toEqual(inOrder)
  })

  test('is drawn the same in every direction, backwards included', () => {
    fc.assert(
      fc.property(fc.double({ min: -4, max: 4, noNaN: true }), (turn) => {
        const at = (angle: number) => beam(50 * Math.cos(turn + angle), 50 * Math.sin(turn + angle))
        const rays = [0, 0.2, -0.2, 0.4, -0.4].map(at)
        const order = [-0.4, -0.2, 0, 0.2, 0.4].map((angle) => at(angle).to)
        expect(conePolygon(rays).slice(1)).toEqual(order)
      }),
    )
  })

  test('without rays there is none', () => {
    expect(conePolygon([])).toEqual([])
    expect(nearestBeam([])).toBeUndefined()
  })

  test('the line goes to the nearest hit, straight ahead when all are equal', () => {
    const near = beam(0, 30)
    expect(nearestBeam([beam(100, 0), near, beam(50, 0)])).toBe(near)
    const equal = [beam(10, 0), beam(0, 10)]
    expect(nearestBeam(equal)).toBe(equal[0])
  })
})

describe('distance labels', () => {
  const robot = { x: 0, y: 0 }
  const length = fc.integer({ min: 1, max: 400 })
  const turn = fc.double({ min: -3.2, max: 3.2, noNaN: true })
  const everywhere = { x: -500, y: -500, width: 1000, height: 1000 }

  test('keep clear of the robot', () => {
    fc.assert(
      fc.property(length, turn, (far, angle) => {
        const [place] = labelPlaces(robot, [beam(far * Math.cos(angle), far * Math.sin(angle))], everywhere)
        expect(Math.hypot(place!.x, place!.y)).toBeGreaterThan(43.9)
      }),
    )
  })

  test('two never lie on each other', () => {
    fc.assert(
      fc.property(length, length, turn, (one, two, angle) => {
        const [a, b] = labelPlaces(
          robot,
          [
            beam(one * Math.cos(angle), one * Math.sin(angle)),
            beam(two * Math.cos(angle + 0.1), two * Math.sin(angle + 0.1)),
          ],
          everywhere,
        )
        expect(Math.hypot((a!.x - b!.x) / 54, (a!.y - b!.y) / 33)).toBeGreaterThan(0.999)
      }),
    )
  })

  test('are never cut off by the edge of what is seen', () => {
    fc.assert(
      fc.property(length, length, turn, (one, two, angle) => {
        const seen = { x: -200, y: -60, width: 400, height: 120 }
        const beams = [one, two].map((far) => beam(far * Math.cos(angle), far * Math.sin(angle)))
        for (const { x, y } of labelPlaces(robot, beams, seen)) {
          expect(Math.abs(x)).toBeLessThanOrEqual(173)
          expect(Math.abs(y)).toBeLessThanOrEqual(43.5)
        }
      }),
    )
  })
})

test('an ultrasonic sensor tells centimetres up to 255, an infrared one 0 to 100 over 70 cm', () => {
  const away = (distance: number) => beam(distance, 0)
  expect(readingOf(false, away(120.6))).toEqual({ hit: true, reading: 121 })
  expect(readingOf(false, away(255))).toEqual({ hit: false, reading: 255 })
  expect(readingOf(true, away(35))).toEqual({ hit: true, reading: 50 })
  expect(readingOf(true, away(70))).toEqual({ hit: false, reading: 100 })
})
