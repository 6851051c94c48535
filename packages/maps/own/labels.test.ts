import type { RoadMap } from '@botgarten/programs'
import { paper } from '@botgarten/programs'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { readMap } from '../index.ts'
import { distance } from '../point.ts'
import { addRoad, addStation, emptyMap, setRoad, setStation } from './edit.ts'
import { labelArea, labelsOf, LARGEST } from './labels.ts'
import { lineOf, sampled } from './line.ts'
import { openMap } from './open.ts'
import { writeMap } from './write.ts'

type Area = ReturnType<typeof labelArea>
const meet = (a: Area, b: Area) => Math.abs(a.x - b.x) < a.w + b.w && Math.abs(a.y - b.y) < a.h + b.h
/** Of a circle. */
const covers = (area: Area, { x, y }: { x: number; y: number }, radius: number) =>
  distance(
    { x: Math.max(Math.abs(area.x - x) - area.w, 0), y: Math.max(Math.abs(area.y - y) - area.h, 0) },
    { x: 0, y: 0 },
  ) < radius

const station = fc.record(
  {
    ...{ x: fc.integer({ min: 80, max: 1520 }), y: fc.integer({ min: 80, max: 920 }) },
    ...{ name: fc.string({ unit: 'grapheme', minLength: 1, maxLength: 60 }), reward: fc.constant(20) },
  },
  { requiredKeys: ['x', 'y'] },
)
const maps = fc
  .record({
    stations: fc.array(station, { minLength: 1, maxLength: 14 }),
    roads: fc.array(fc.tuple(fc.nat(13), fc.nat(13), fc.boolean()), { maxLength: 14 }),
  })
  .map(({ stations, roads }): RoadMap => {
    const between = roads.flatMap(([a, b, pays]) => {
      const [from, to] = [a % stations.length, b % stations.length]
      return from === to ? [] : [{ from, to, bends: [], ...(pays && { reward: -5 }) }]
    })
    return { ...emptyMap('x'), stations, roads: between, start: 0, goals: [0] }
  })

describe('the names of stations', () => {
  test('never cover a number, a reward, the middle of a road or each other, and are on the paper', () => {
    fc.assert(
      fc.property(maps, fc.constantFrom(1, LARGEST), (map, times) => {
        const areas = labelsOf(map).map((label, at) =>
          label ? labelArea(map.stations[at]!, label, times) : null,
        )
        for (const [at, area] of areas.entries()) {
          if (!area) continue
          for (const other of areas.slice(at + 1)) if (other) expect(meet(area, other)).toBe(false)
          for (const { x, y, reward } of map.stations) {
            expect(covers(area, { x, y }, 46 * times)).toBe(false)
            if (reward) expect(covers(area, { x: x - 46, y: y + 46 }, 32)).toBe(false)
          }
          for (const road of map.roads) {
            const points = sampled(lineOf(map, road).there)
            const middle = points[Math.floor(points.length / 2)]!
            expect(covers(area, middle, 40)).toBe(false)
            if (road.reward) expect(covers(area, { x: middle.x + 52, y: middle.y + 40 }, 32)).toBe(false)
          }
          expect(Math.min(area.x - area.w, area.y - area.h)).toBeGreaterThan(0)
          expect(area.x + area.w).toBeLessThan(paper.width)
          expect(area.y + area.h).toBeLessThan(paper.height)
        }
      }),
    )
  })

  const named = () => {
    const places = [[300, 300], [800, 300], [1300, 300], [800, 700]] as const // prettier-ignore
    const names = ['Haus', 'Brunnen am Markt', 'Schule', 'Bäckerei']
    let map = emptyMap('Ort')
    for (const [at, [x, y]] of places.entries()) {
      map = addStation(map, { x, y })
      map = setStation(map, at, { name: names[at]! })
    }
    for (const [from, to] of [[0, 1], [1, 2], [1, 3], [3, 0], [3, 2]] as const) map = addRoad(map, from, to) // prettier-ignore
    return { map: setRoad(map, 0, { reward: 10 }), names }
  }

  test('are all shown where there is room, and lie on no road where a free place is', () => {
    const { map, names } = named()
    const labels = labelsOf(map)
    expect(labels.map((label) => label?.text)).toEqual(names)
    const points = map.roads.flatMap((road) => sampled(lineOf(map, road).there))
    for (const [at, label] of labels.entries()) {
      const area = labelArea(map.stations[at]!, label!, 1)
      expect(points.filter((point) => covers(area, point, 1))).toEqual([])
    }
  })

  test('are drawn, read by the learner, and open again as they were', () => {
    const { map, names } = named()
    const svg = writeMap(map, 'ort')
    for (const name of names) expect(svg).toContain(`>${name}</text>`)
    const read = readMap(svg)
    expect(read.problems).toEqual([])
    expect(read.map!.stations.map(({ name }) => name)).toEqual(names)
    expect(openMap(svg, 'ort').map).toEqual(map)
  })

  test('that are long end with dots; a station without a name has no label', () => {
    const { map } = named()
    const name = 'Bäckerei der sieben Tanten'
    expect(labelsOf(setStation(map, 3, { name }))[3]!.text).toBe('Bäckerei der sieb…')
    // Less room, fewer letters.
    expect(labelsOf(setStation(map, 0, { name }))[0]!.text).toBe('Bäckerei de…')
    expect(labelsOf(setStation(map, 0, { name: undefined }))[0]).toBeNull()
  })
})
