import { content } from '@botgarten/content/files'
import { describe, expect, test } from 'vitest'
import { freeSpot, keptFree } from './free-spot.ts'

const map = { width: 1600, height: 1000 }

describe('a chip on the map', () => {
  test('stands in the first corner that has no station', () => {
    expect(freeSpot({ width: 300, height: 100 }, map, [{ x: 100, y: 950 }], [], 60)).toEqual([1, 1])
  })

  test('leaves roads free where it can', () => {
    const roads = [{ x: 100, y: 950 }, { x: 1500, y: 950 }] // prettier-ignore
    expect(freeSpot({ width: 300, height: 100 }, map, [], roads, 60)).toEqual([0, 0])
  })

  test('covers no station, or there is no place', () => {
    const all = Array.from({ length: 160 }, (_, at) => ({ x: (at % 16) * 100, y: Math.floor(at / 16) * 100 }))
    expect(freeSpot({ width: 300, height: 100 }, map, all, [], 60)).toBeNull()
  })

  test('keeps Bo above the start and the flag above the goal free, too', () => {
    const stations = [{ x: 100, y: 950 }, { x: 1500, y: 950 }, { x: 100, y: 110 }] // prettier-ignore
    expect(keptFree(stations, [2, 1])).toEqual([...stations, { x: 100, y: 30 }, { x: 1500, y: 870 }])
    // Upper left corner: the station alone would leave it free, Bo above it does not.
    const corners = [[100, 950], [1500, 950]].map(([x, y]) => ({ x: x!, y: y! })) // prettier-ignore
    const chip = { width: 300, height: 40 }
    expect(freeSpot(chip, map, [...corners, stations[2]!], [], 20)).toEqual([0, 0])
    expect(freeSpot(chip, map, keptFree([...corners, stations[2]!], [2]), [], 20)).toEqual([1, 0])
  })

  test('while another map loads, leaves out a start and a goal that this map lacks', () => {
    const stations = [{ x: 100, y: 950 }]
    expect(keptFree(stations, [15, 0])).toEqual([...stations, { x: 100, y: 870 }])
  })

  // As large as the invitation is on a map of 640 px.
  test.each(['railway', 'forest', 'city', 'mars', 'fountain', 'roundabout'])(
    'has a place on the map %s',
    (id) => {
      const { size, stations } = content.mapFile(id)!
      const scale = size.width / 640
      expect(freeSpot({ width: 230 * scale, height: 52 * scale }, size, stations, [], 50)).not.toBeNull()
    },
  )
})
