import {
  isMap,
  covers,
  dresses,
  parseProject,
  writeProject,
  stationsOf,
  versionOf,
  type RoadMap,
} from '@botgarten/programs'
import { isLong } from '@botgarten/numbers/testing'
import { project as everyPart } from '../../programs/testing/every-part.ts'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { readMap } from '../index.ts'
import { mapLookup } from '../lookup.ts'
import {
  addRoad,
  addStation,
  emptyMap,
  faultsOf,
  openMap,
  reachOf,
  removeStation,
  setRoad,
  setStart,
  toggleGoal,
  turnRoad,
  writeMap,
} from './index.ts'

const place = { x: fc.integer({ min: 80, max: 1520 }), y: fc.integer({ min: 80, max: 920 }) }
const reward = fc.integer({ min: -100, max: 100 })
const name = fc
  .string({ unit: 'grapheme', maxLength: 20 })
  .filter((text) => !/[\p{Cc}\p{Cs}\uFFFE\uFFFF]/u.test(text))

/** Maps of every kind that the schema lets through. */
const maps: fc.Arbitrary<RoadMap> = fc
  .array(fc.record({ ...place, name, reward }, { requiredKeys: ['x', 'y'] }), { minLength: 2, maxLength: 8 })
  .chain((stations) => {
    const index = fc.integer({ min: 0, max: stations.length - 1 })
    const road = fc.record(
      {
        ...{ from: index, to: index, bends: fc.array(fc.record(place), { maxLength: 4 }) },
        ...{ oneWay: fc.constant(true as const), closed: fc.constantFrom('both', 'there', 'back') },
        ...{ reward, slip: fc.constantFrom(0.1, 0.25, 1 / 3) },
      },
      { requiredKeys: ['from', 'to', 'bends'] },
    )
    return fc.record(
      {
        ...{
          kind: fc.constant('roads'),
          name,
          dress: fc.constantFrom(...dresses),
          stations: fc.constant(stations),
        },
        roads: fc.array(road, { maxLength: 12 }),
        ...{ start: index, goals: fc.uniqueArray(index, { minLength: 1 }) },
        ...{ photo: fc.base64String({ minLength: 4 }).map((rest) => `/9j/${rest}`) },
        ...{ cover: fc.constantFrom(...covers), endless: fc.constant(true), stepCost: reward },
        lengthCounts: fc.constant(true),
      },
      { requiredKeys: ['kind', 'name', 'dress', 'stations', 'roads', 'start', 'goals'] },
    )
  })
  .map(({ photo, ...map }) =>
    map.dress === 'photo' && photo
      ? { ...map, photo }
      : { ...map, dress: map.dress === 'photo' ? 'sea' : map.dress },
  ) // prettier-ignore
  .filter(isMap)

describe('a drawn map', () => {
  test('saved as SVG and opened again is the same', () => {
    fc.assert(
      fc.property(maps, (map) => {
        const text = writeMap(map, 'mine')
        expect(openMap(text, 'other')).toEqual({ map, warnings: [], picture: null })
      }),
      { numRuns: isLong ? 500 : 50, seed: 2026 },
    )
  }, 600_000)

  test('has the roads, signs and odds for the learner that it was drawn with', () => {
    const drawn = [{ x: 200, y: 200 }, { x: 700, y: 200 }, { x: 700, y: 700 }].reduce(addStation, emptyMap('x')) // prettier-ignore
    const roads = addRoad(addRoad(addRoad(drawn, 0, 1), 1, 2), 0, 2)
    const map = setRoad(setRoad(turnRoad(roads, 0), 1, { closed: 'back', reward: 5 }), 2, { slip: 0.25 })
    const paid: RoadMap = { ...toggleGoal(map, 2), stepCost: 3, lengthCounts: true, endless: true }
    const { map: file } = readMap(writeMap(paid, 'x'))
    expect(file).toMatchObject({ id: 'own:x', start: 0, goal: 1, map: { goals: [2], endless: true } })
    expect(file).toMatchObject({ stepCost: 3, lengthCost: 0.02 })
    const moves = file!.map.actions.map((list) => list.map(({ to, reward, slip }) => ({ to, reward, slip })))
    expect(moves).toEqual([
      [
        { to: 1, reward: undefined, slip: undefined },
        { to: 2, reward: undefined, slip: 0.25 },
      ],
      [{ to: 2, reward: 5, slip: undefined }],
      [{ to: 0, reward: undefined, slip: 0.25 }],
    ])
  })

  test.each(dresses)(
    'in the dress %s has a colour for all that is painted, and a name of its own for each layer',
    (dress) => {
      const stations = [
        { x: 200, y: 200 },
        { x: 700, y: 700 },
      ].reduce(addStation, emptyMap('x'))
      for (const cover of [undefined, ...covers]) {
        const text = writeMap({ ...addRoad(stations, 0, 1), dress, ...(cover && { cover }) }, 'x')
        expect(text).not.toMatch(/(fill|stroke)=""/)
        const names = [...text.matchAll(/ id="([^"]*)"/g)].map(([, id]) => id)
        expect(names).not.toContain('')
        expect(new Set(names).size).toBe(names.length)
      }
    },
  )

  test('belongs to its project, which is of version 2 then and comes back the same', () => {
    const map = addRoad(
      [
        { x: 200, y: 200 },
        { x: 700, y: 200 },
      ].reduce(addStation, emptyMap('x')),
      0,
      1,
    )
    const maps = { 'to-the-pond': map }
    expect([versionOf({}), versionOf({ maps })]).toEqual([1, 2])
    const project = { ...everyPart, botgarten: versionOf({ maps }), maps }
    expect(parseProject(writeProject(project))).toEqual(project)
    expect(stationsOf(project)).toEqual({ 'to-the-pond': 2 })
    const lookup = mapLookup(project, () => null)
    expect(lookup('own:to-the-pond')?.stations).toHaveLength(2)
    expect([lookup('own:other'), lookup('railway')]).toEqual([null, null])
  })
})

describe('what is said of a map', () => {
  const square = [[200, 200], [700, 200], [700, 700], [200, 700], [1200, 200]] // prettier-ignore
    .map(([x, y]) => ({ x: x!, y: y! }))
    .reduce(addStation, emptyMap('square'))
  const ring = addRoad(addRoad(addRoad(addRoad(square, 0, 1), 1, 2), 2, 3), 3, 0)

  test('a way of fewest roads, dead ends, what cannot be reached, and a circle', () => {
    expect(reachOf(addRoad({ ...ring, goals: [2] }, 1, 4))).toEqual({
      ...{ way: [0, 1, 2], lost: [], circle: [0, 1, 2, 3, 0] },
      deadEnds: [{ station: 4, out: true }],
    })
    expect(reachOf({ ...ring, goals: [4] })).toMatchObject({ way: null, lost: [4] })
  })

  test('signs and one-way roads count', () => {
    const shut = setRoad(setRoad({ ...ring, goals: [1] }, 0, { closed: 'there' }), 1, { oneWay: true })
    expect(reachOf(shut).way).toBeNull()
  })

  test('roads that are too short or too tight are named with what they measure', () => {
    const near = addRoad(
      [
        { x: 200, y: 200 },
        { x: 300, y: 200 },
      ].reduce(addStation, emptyMap('near')),
      0,
      1,
    )
    expect(faultsOf(near)).toEqual([{ road: 0, kind: 'short', cm: 20 }])
  })

  test('a road that crosses itself is named, one that only turns round is not', () => {
    const loop = (...bends: RoadMap['roads'][number]['bends']) => {
      const two = [{ x: 200, y: 500 }, { x: 1000, y: 500 }].reduce(addStation, emptyMap('loop')) // prettier-ignore
      return setRoad(addRoad(two, 0, 1), 0, { bends })
    }
    expect(faultsOf(loop({ x: 900, y: 800 }, { x: 600, y: 100 }))).toEqual([])
    const crossed = loop({ x: 900, y: 800 }, { x: 900, y: 200 }, { x: 300, y: 800 })
    expect(faultsOf(crossed)).toEqual([{ road: 0, kind: 'crosses' }])
  })
})

describe('editing a map', () => {
  test('a station goes with its roads, and the others keep theirs', () => {
    const drawn = [0, 1, 2, 3].map((k) => ({ x: 200 + 300 * k, y: 300 })).reduce(addStation, emptyMap('row'))
    const row = addRoad(addRoad(addRoad({ ...drawn, goals: [3] }, 0, 1), 1, 2), 2, 3)
    const left = removeStation(row, 1)
    expect(left.roads).toEqual([{ from: 1, to: 2, bends: [] }])
    expect(left).toMatchObject({ start: 0, goals: [2] })
  })

  test('whatever is done, the map stays one', () => {
    const index = fc.nat(9)
    const edit = fc.oneof(
      fc.record({ do: fc.constant('station'), ...place }),
      fc.record({ do: fc.constantFrom('road', 'remove', 'start', 'goal', 'turn'), a: index, b: index }),
    )
    fc.assert(
      fc.property(fc.array(edit, { maxLength: 40 }), (edits) => {
        const map = edits.reduce((map, one) => {
          if ('x' in one) return addStation(map, one)
          const inside = (station: number) => station < map.stations.length
          if (one.do === 'turn') return one.a < map.roads.length ? turnRoad(map, one.a) : map
          if (!inside(one.a) || !inside(one.b)) return map
          if (one.do === 'road') return addRoad(map, one.a, one.b)
          if (one.do === 'remove') return removeStation(map, one.a)
          return one.do === 'start' ? setStart(map, one.a) : toggleGoal(map, one.a)
        }, emptyMap('any'))
        expect(isMap(map)).toBe(true)
      }),
      { seed: 2026 },
    )
  })
})
