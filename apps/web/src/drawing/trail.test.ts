import type { TrailPoint } from '@botgarten/lab'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { dotsAlong, Trails } from './trail.ts'

const points = fc.array(
  fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 300 }) }),
  { maxLength: 20 },
)

describe('a trail', () => {
  test('has dots at equal distances along its way', () => {
    const { dots } = dotsAlong(
      [
        { x: 0, y: 0 },
        { x: 25, y: 0 },
        { x: 25, y: 20 },
      ],
      10,
    )
    expect(dots).toEqual([
      { x: 0, y: 0 },
      { x: 10, y: 0 },
      { x: 20, y: 0 },
      { x: 25, y: 5 },
      { x: 25, y: 15 },
    ])
  })

  test('dotted piece by piece is the trail dotted at once', () => {
    fc.assert(
      fc.property(points, fc.nat(20), (way, cut) => {
        const first = dotsAlong(way.slice(0, cut), 7)
        const second = dotsAlong(way.slice(cut), 7, first.dotting)
        expect([...first.dots, ...second.dots]).toEqual(dotsAlong(way, 7).dots)
      }),
    )
  })
})

describe('the trails of all robots', () => {
  const room = { width: 300, height: 300 }
  const way = fc
    .array(fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 300 }) }), {
      minLength: 2,
      maxLength: 60,
    })
    .map((all) => all.map((point, t) => ({ ...point, t, heading: 0 })))
  const dotted = (trails: Trails, trail: readonly TrailPoint[], scale: number) =>
    trails.dots([{ id: 'bo', trail }], room, scale, ['#F28C45'])
  function dotsOf(trails: Trails, trail: readonly TrailPoint[], scale: number) {
    const { done, growing } = dotted(trails, trail, scale)
    return [...done, ...growing].map((shape) => (shape.kind === 'path' ? shape.d : '')).join('')
  }

  test('grow to the same dots as if they had been dotted at once', () => {
    fc.assert(
      fc.property(way, (trail) => {
        const growing = new Trails()
        trail.forEach((_, count) => dotsOf(growing, trail.slice(0, count + 1), 2))
        expect(dotsOf(growing, trail, 2)).toBe(dotsOf(new Trails(), trail, 2))
      }),
    )
  })

  test('go back and on with time to the same dots as if they had been dotted at once', () => {
    const long = Array.from({ length: 400 }, (_, t) => ({
      x: (t * 7) % 300,
      y: (t * 3) % 200,
      t,
      heading: 0,
    }))
    fc.assert(
      fc.property(fc.array(fc.nat(400), { maxLength: 12 }), (ends) => {
        const trails = new Trails()
        for (const end of ends) {
          const trail = long.slice(0, end)
          expect(dotsOf(trails, trail, 2)).toBe(dotsOf(new Trails(), trail, 2))
        }
      }),
      { numRuns: 30 },
    )
  })

  test('that take another way from a moment on are dotted from there', () => {
    const way = (turn: number) =>
      Array.from({ length: 300 }, (_, t) => ({ x: t, y: t < 150 ? 0 : (t - 150) * turn, t, heading: 0 }))
    const trails = new Trails()
    dotsOf(trails, way(1), 2)
    expect(dotsOf(trails, way(-1), 2)).toBe(dotsOf(new Trails(), way(-1), 2))
  })

  test('are the same paths but for the last dots, so that they need not be painted again', () => {
    const line = Array.from({ length: 200 }, (_, t) => ({ x: t, y: 0, t, heading: 0 }))
    const trails = new Trails()
    const { done } = dotted(trails, line.slice(0, -1), 3)
    expect(done.length).toBeGreaterThan(0)
    expect(dotted(trails, line, 3).done).toBe(done)
  })

  test('of several robots keep their order: new dots stand behind those that are painted', () => {
    const line = (y: number) => Array.from({ length: 200 }, (_, t) => ({ x: t, y, t, heading: 0 }))
    const trails = new Trails()
    const at = (count: number) =>
      trails.dots(
        [0, 50].map((y) => ({ id: `bo${y}`, trail: line(y).slice(0, count) })),
        room,
        5,
        ['#F28C45', '#2F9C95'],
      ).done
    const [before, after] = [at(100), at(200)]
    expect(before.length).toBeGreaterThan(1)
    expect(after.length).toBeGreaterThan(before.length)
    expect(after.slice(0, before.length)).toEqual(before)
  })

  test('begin again where time went back, and at another scale', () => {
    fc.assert(
      fc.property(way, (trail) => {
        const trails = new Trails()
        dotsOf(trails, trail, 2)
        expect(dotsOf(trails, trail.slice(0, 1), 2)).toBe('')
        expect(dotsOf(trails, trail, 3)).toBe(dotsOf(new Trails(), trail, 3))
      }),
    )
  })
})
