import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { labelSides } from './labels.ts'
import type { Point } from './points.ts'

const places: readonly Point[] = [
  { x: 0, y: -39 },
  { x: 0, y: 39 },
  { x: 42, y: 0 },
  { x: -42, y: 0 },
]
const sides = ['above', 'below', 'right', 'left'] as const
const stage = { width: 400, height: 900 }
/** Knobs are counted from 200 px below the stage's edge. */
const lowered = (knobs: readonly Point[]) => knobs.map(({ x, y }) => ({ x, y: y + 200 }))
const written = (knobs: readonly Point[]) =>
  labelSides(lowered(knobs), Array(knobs.length).fill(0.5) as number[], stage)

describe('written weights', () => {
  test('stand above their knobs where nothing is in the way', () => {
    expect(
      written([
        { x: 0, y: 0 },
        { x: 0, y: 120 },
      ]),
    ).toEqual(['above', 'above'])
  })

  test('of two crossing links with the same weight stand on either side', () => {
    expect(
      written([
        { x: 267, y: 415 },
        { x: 267, y: 365 },
      ]),
    ).toEqual(['below', 'above'])
  })

  test('stand beside the middle one of three', () => {
    expect(written([0, 50, 100].map((y) => ({ x: 0, y })))).toEqual(['above', 'right', 'below'])
  })

  test('leave free the name of a neuron that is in their way', () => {
    const knobs = lowered([0, 50, 100].map((y) => ({ x: 0, y })))
    const name = { x: 50, y: 250 }
    expect(labelSides(knobs, [0.5, 0.5, 0.5], stage, [name])).toEqual(['above', 'left', 'below'])
  })

  test('of 0 take no room', () => {
    const knobs = [0, 90].map((x) => ({ x, y: 0 }))
    const all = lowered([{ x: 45, y: -39 }, ...knobs])
    expect(labelSides(all, [0, 0.5, 0.5], stage)).toEqual(['above', 'above', 'above'])
  })

  test('stay on the stage', () => {
    const edges = [20, 100].map((y) => ({ x: 0, y }))
    expect(labelSides(edges, [0.5, 0.5], { width: 400, height: 120 })).toEqual(['below', 'right'])
  })

  test('cover a knob or another weight only where no side is free', () => {
    const place = fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 300 }) })
    fc.assert(
      fc.property(fc.array(place, { maxLength: 12 }), (knobs) => {
        const at = (k: number, side: number) => ({
          x: knobs[k]!.x + places[side]!.x,
          y: knobs[k]!.y + places[side]!.y,
        })
        const earlier: Point[] = []
        written(knobs).forEach((side, k) => {
          const free = (n: number) =>
            !knobs.some(
              (other, j) =>
                j !== k && Math.abs(other.x - at(k, n).x) < 34 && Math.abs(other.y - at(k, n).y) < 26,
            ) &&
            !earlier.some(
              (other) => Math.abs(other.x - at(k, n).x) < 48 && Math.abs(other.y - at(k, n).y) < 28,
            )
          const taken = sides.indexOf(side)
          if (!free(taken)) expect(sides.map((_, n) => free(n))).toEqual([false, false, false, false])
          earlier.push(at(k, taken))
        })
      }),
      { seed: 7 },
    )
  })
})
