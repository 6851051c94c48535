import { expect, test } from 'vitest'
import { readMap } from './index.ts'
import { addRoad, addStation, emptyMap, writeMap } from './own/index.ts'
import { legsOf } from './way.ts'

test('a way is said leg by leg: how far to turn at a station and how far to drive, at the end nothing any more', () => {
  const stations = [{ x: 200, y: 200 }, { x: 700, y: 200 }, { x: 700, y: 700 }] // prettier-ignore
  const drawn = addRoad(addRoad(stations.reduce(addStation, emptyMap('corner')), 0, 1), 1, 2)
  const legs = legsOf(readMap(writeMap(drawn, 'corner')).map!, [0, 1, 2])
  // To the right on the paper, then down: a quarter turn to the right. 500 units of 0.2 cm are 100 cm.
  expect(legs.map(({ station }) => station)).toEqual([0, 1, 2])
  expect(legs.map(({ turn }) => Math.round(turn))).toEqual([0, 90, 0])
  expect(legs.map(({ length }) => Math.round(length))).toEqual([100, 100, 0])
})
