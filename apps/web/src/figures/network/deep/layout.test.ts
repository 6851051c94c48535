import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { distance } from '#drawing/points.ts'
import { freeLine, knobPlace, unitScale } from '#drawing/track.ts'
import { layoutDeep, nearTo, settleDeep } from './layout.ts'

const room = { width: 456, height: 320 }
const layers = fc.array(fc.integer({ min: 1, max: 12 }), { minLength: 3, maxLength: 6 })
const signed = { least: -1, most: 1, unit: 1 } as const

const tracksOf = (counts: readonly number[], scale = unitScale) => {
  const { columns, radius } = layoutDeep(room, counts, true)
  return columns
    .slice(1)
    .flatMap((column, k) => columns[k]!.flatMap((a) => column.map((b) => freeLine(a, b, radius, scale))))
}

describe('the nodes of a deeper network', () => {
  test('are never smaller than a finger, never touch, and stand on the stage', () => {
    fc.assert(
      fc.property(layers, fc.boolean(), (counts, tools) => {
        const { radius, columns, stage } = layoutDeep(room, counts, tools)
        expect(radius).toBeGreaterThanOrEqual(22)
        expect(columns.map((column) => column.length)).toEqual(counts)
        for (const column of columns)
          for (let k = 1; k < column.length; k++)
            expect(column[k]!.y - column[k - 1]!.y).toBeGreaterThanOrEqual(2 * radius + 12)
        for (let k = 1; k < columns.length; k++)
          expect(columns[k]![0]!.x - columns[k - 1]![0]!.x).toBeGreaterThanOrEqual(2 * radius + 40)
        for (const { x, y } of columns.flat()) {
          expect(x + radius <= stage.width && x >= radius).toBe(true)
          expect(y + radius <= stage.height && y - radius >= (tools ? 48 : 0)).toBe(true)
        }
      }),
      { seed: 3 },
    )
  })

  test('of two, three and two fit into the pane of a laptop', () => {
    const { stage } = layoutDeep(room, [2, 3, 2], true)
    expect(stage).toEqual(room)
  })

  test('leave room for knobs: of 200 neurons in ten layers no resting knob, 22 px wide, covers another', () => {
    for (const scale of [unitScale, signed]) {
      const tracks = settleDeep(tracksOf(Array<number>(10).fill(20), scale))
      expect(tracks).toHaveLength(3600)
      const knobs = tracks.slice(0, 400).map((track) => knobPlace(track, 0))
      const gaps = knobs.flatMap((a, k) => knobs.slice(k + 1).map((b) => distance(a, b)))
      expect(Math.min(...gaps)).toBeGreaterThanOrEqual(22)
    }
  })
})

describe('what is drawn of a big net', () => {
  const tracks = tracksOf(Array<number>(10).fill(20))

  test('is a small part of it, and everything that runs through what is seen', () => {
    const at = { x: 1000, y: 500 }
    const near = nearTo(room, at, tracks.length)!
    const drawn = tracks.filter(near)
    expect(drawn.length).toBeLessThan(tracks.length / 2)
    const inside = (x: number, y: number) =>
      x > at.x && x < at.x + room.width && y > at.y && y < at.y + room.height
    for (const track of tracks) {
      const through = Array.from({ length: 50 }, (_, k) => k / 49).some((share) =>
        inside(
          track.from.x + (track.to.x - track.from.x) * share,
          track.from.y + (track.to.y - track.from.y) * share,
        ),
      )
      if (through) expect(drawn).toContain(track)
    }
  })

  test('is all of a small one', () => {
    expect(nearTo(room, { x: 0, y: 0 }, 40)).toBeUndefined()
  })
})
