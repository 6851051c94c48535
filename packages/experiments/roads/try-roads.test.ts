import { readMap } from '@botgarten/maps'
import { addRoad, addStation, emptyMap, faultsOf, lineOf, setRoad, writeMap } from '@botgarten/maps/own'
import type { MapDocument } from '@botgarten/programs'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { drivesRoad, roadsToTry } from './try-roads.ts'

const two = (bends: MapDocument['roads'][number]['bends'], to = { x: 700, y: 500 }) => {
  const stations = [{ x: 200, y: 500 }, to].reduce(addStation, emptyMap('two'))
  return setRoad(addRoad(stations, 0, 1), 0, { bends })
}
const fileOf = (map: MapDocument) => readMap(writeMap(map, 'two')).map!

test('a drawn road is tried in both directions, and driven', () => {
  const map = fileOf(two([{ x: 450, y: 300 }]))
  expect(roadsToTry(map)).toEqual([
    [0, 1],
    [1, 0],
  ])
  expect(roadsToTry(map).map((road) => drivesRoad(map, road))).toEqual([true, true])
})

test('a bend that the rule calls too tight is one that the robot loses', () => {
  const map = two([
    { x: 400, y: 500 },
    { x: 400, y: 560 },
    { x: 440, y: 500 },
  ])
  expect(faultsOf(map)).toMatchObject([{ road: 0, kind: 'tight' }])
  expect(lineOf(map, map.roads[0]!).radii.some((radius) => radius < 12)).toBe(true)
})

test('every road that the rule calls drivable is driven', () => {
  const place = fc.record({ x: fc.integer({ min: 100, max: 900 }), y: fc.integer({ min: 100, max: 900 }) })
  const drivable = fc
    .record({ bends: fc.array(place, { maxLength: 2 }), to: place })
    .map(({ bends, to }) => two(bends, to))
    .filter((map) => faultsOf(map).length === 0 && lineOf(map, map.roads[0]!).length < 200)
  for (const map of fc.sample(drivable, { numRuns: 12, seed: 2026 })) {
    const file = fileOf(map)
    expect(
      roadsToTry(file).filter((road) => !drivesRoad(file, road)),
      JSON.stringify(map),
    ).toEqual([])
  }
})
