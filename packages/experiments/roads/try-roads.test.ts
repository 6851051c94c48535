import { readMap } from '@botgarten/maps'
import { addRoad, addStation, emptyMap, faultsOf, lineOf, setRoad, writeMap } from '@botgarten/maps/own'
import type { RoadMap } from '@botgarten/programs'
import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { drivesRoad, roadsToTry } from './try-roads.ts'

const two = (bends: RoadMap['roads'][number]['bends'], to = { x: 700, y: 500 }) => {
  const stations = [{ x: 200, y: 500 }, to].reduce(addStation, emptyMap('two'))
  return setRoad(addRoad(stations, 0, 1), 0, { bends })
}
const fileOf = (map: RoadMap) => readMap(writeMap(map, 'two')).map!

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

test('every road of random maps that the rule calls drivable is driven, in both directions', () => {
  const place = fc.record({ x: fc.integer({ min: 100, max: 1500 }), y: fc.integer({ min: 100, max: 900 }) })
  const bends = fc.array(place, { maxLength: 2 })
  const map = fc
    .tuple(fc.array(place, { minLength: 3, maxLength: 5 }), fc.array(bends, { minLength: 4, maxLength: 4 }))
    .map(([places, all]) => {
      const stations = places.reduce(addStation, emptyMap('any'))
      return all.reduce((map, bends, k) => {
        const next = addRoad(map, k % places.length, (k + 1) % places.length)
        return next === map ? map : setRoad(next, next.roads.length - 1, { bends })
      }, stations)
    })
    .filter((map) => drivable(map).length > 0)
  const [count, roadsOfEach] = isLong ? [50, Infinity] : [6, 1]
  for (const one of fc.sample(map, { numRuns: count, seed: 2026 })) {
    const file = fileOf(one)
    const tried = roadsToTry(file).filter(([a, b]) =>
      drivable(one)
        .slice(0, roadsOfEach)
        .some(({ from, to }) => (from === a && to === b) || (from === b && to === a)),
    )
    expect(
      tried.filter((road) => !drivesRoad(file, road)),
      JSON.stringify(one),
    ).toEqual([])
  }
}, 600_000)

const drivable = (map: RoadMap) => {
  const faulty = new Set(faultsOf(map).map(({ road }) => road))
  return map.roads.filter((road, index) => !faulty.has(index) && (isLong || lineOf(map, road).length < 150))
}
