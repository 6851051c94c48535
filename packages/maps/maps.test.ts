import { content } from '@botgarten/content/files'
import { stream } from '@botgarten/numbers'
import { greedyPath, createLearner, layOutWorld, run } from '@botgarten/learning/q-learning'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import type { LearningOutline } from '@botgarten/programs'
import { courseOf, isShortest, readMap, segmentsOf, type MapFile, type Point } from './index.ts'

const ids = content.maps
const textOf = (id: string) => content.map(id)!

function mapOf(id: string): MapFile {
  const { map, problems, warnings } = readMap(textOf(id))
  expect([...problems, ...warnings]).toEqual([])
  return map!
}

const edgesOf = ({ map }: MapFile) =>
  map.actions.flatMap((moves, from) => moves.filter(({ to }) => from < to).map(({ to }) => `${from}-${to}`))

/** The graphs of spec/q-learning-playground.md, "Maps". */
const graphs = {
  railway: '0-1 0-5 1-2 2-3 3-4 3-5 4-5',
  forest: '0-1 0-2 1-4 1-8 2-3 2-8 3-4 3-5 4-6 5-6 5-7 6-7 8-9',
  city: '0-1 1-2 1-3 2-3 2-5 2-7 3-4 4-6 4-16 4-17 5-6 5-7 5-8 6-8 6-16 7-9 7-18 8-9 8-10 9-10 9-11 9-18 10-11 11-12 11-14 12-13 12-19 13-14 13-15 13-19 14-15 15-16 16-17 18-19',
  mars: '0-3 1-2 1-4 2-5 3-4 3-6 4-5 4-7 5-8',
}

describe.each(ids)('the map %s', (id) => {
  test('is called like its folder, breaks no rule and can be laid out', () => {
    const map = mapOf(id)
    expect(map.id).toBe(id)
    expect(() => layOutWorld({ map: map.map, start: map.start ?? 0, goal: map.goal ?? 0 })).not.toThrow()
  })

  test('has roads that lead from the middle of a station to the middle of another', () => {
    const { roads, stations } = mapOf(id)
    for (const [name, line] of Object.entries(roads)) {
      const [from, to] = name.split('-').map((station) => stations[Number(station)]!)
      const segments = segmentsOf(line)!
      const gap = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y)
      expect(gap(segments[0]!.from, from!)).toBeLessThan(1)
      expect(gap(segments.at(-1)!.to, to!)).toBeLessThan(1)
    }
  })

  test('has every road in both directions, equally long, and at least 40 cm for the robot', () => {
    const { map, cmPerUnit } = mapOf(id)
    map.actions.forEach((moves, from) => {
      for (const { to, length, outcomes } of moves) {
        if (outcomes) continue
        const back = map.actions[to]!.find((move) => move.to === from)
        expect(Math.abs(back!.length! - length!)).toBeLessThan(0.5)
        expect(length! * cmPerUnit).toBeGreaterThanOrEqual(40)
      }
    })
  })
})

test.each(Object.entries(graphs))('%s is drawn on its true graph', (id, edges) => {
  expect(edgesOf(mapOf(id)).join(' ')).toBe(edges)
})

test('the roundabout pays for walking in circles, and a step cost fixes it', () => {
  const { map, start, goal } = mapOf('roundabout')
  const way = (stepCost: number) => {
    const world = layOutWorld({ map, start: start!, goal: goal!, stepCost })
    const settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.9 } as const
    const learner = createLearner(world, settings, stream(1, 'learn/roundabout/1'))
    run(learner, 20_000)
    return greedyPath(learner)
  }
  expect(way(0)).toMatchObject({ states: null, reason: 'circle' })
  expect(way(15)).toMatchObject({ reason: 'found', states: [0, 1, 2, 3, 4, 7] })
})

describe('a broken map', () => {
  const node = (id: number, x: number) => `<g id="node-${id}" transform="translate(${x} 0)"/>`
  const path = (name: string, d: string) => `<path id="path-${name}" d="${d}"/>`
  const svg = (content: string, root = '') =>
    `<svg xmlns="http://www.w3.org/2000/svg" ${root}>${content}</svg>`
  const two = node(0, 0) + node(1, 100)
  const problemsIn = (text: string) => readMap(text).problems

  test.each([
    ['cut off', svg(two).slice(0, -8), { kind: 'notXml', facts: { line: 1 } }],
    ['no SVG', '<html/>', { kind: 'noDrawing', facts: {} }],
    ['more than a drawing', svg(two + '<script/>'), { kind: 'unsafe', facts: { name: 'script' } }],
    ['something that runs', svg(two + '<g onload="x"/>'), { kind: 'unsafe', facts: { name: 'onload' } }],
    ['something from outside', svg(two + '<g fill="url(x)"/>'), { kind: 'unsafe', facts: { name: 'fill' } }],
    ['two of one name', svg(two + node(1, 50)), { kind: 'idTwice', facts: { name: 'node-1' } }],
    ['no station', svg(''), { kind: 'noStations', facts: {} }],
    ['a gap', svg(node(0, 0) + node(2, 9)), { kind: 'stationMissing', facts: { name: 'node-1', count: 2 } }],
    [
      'a station without a place',
      svg('<g id="node-0"/>'),
      { kind: 'stationPlace', facts: { name: 'node-0' } },
    ],
    [
      'a road to nowhere',
      svg(two + path('1-9', 'M0 0L1 1')),
      { kind: 'pathToNowhere', facts: { name: 'path-1-9', station: 9 } },
    ],
    [
      'a road to itself',
      svg(two + path('1-1', 'M0 0L1 1')),
      { kind: 'pathToItself', facts: { name: 'path-1-1' } },
    ],
    [
      'a road that nobody can read',
      svg(two + path('0-1', 'M0 0C1 1 2 2 100')),
      { kind: 'pathShape', facts: { name: 'path-0-1' } },
    ],
    [
      'a late end',
      svg(two + path('0-1', 'M0 0L90 0')),
      { kind: 'pathEnd', facts: { name: 'path-0-1', station: 1 } },
    ],
    [
      'a late start',
      svg(two + path('0-1', 'M9 0L100 0')),
      { kind: 'pathEnd', facts: { name: 'path-0-1', station: 0 } },
    ],
    [
      'a word for a number',
      svg(two, 'data-goal="x"'),
      { kind: 'number', facts: { name: 'data-goal', value: 'x' } },
    ],
    [
      'an odd grid',
      svg(two, 'data-grid="SX"'),
      { kind: 'grid', facts: { why: 'A grid has no cell X: S G F H C W P I.' } },
    ],
  ])('%s is named', (_, text, problem) => {
    expect(problemsIn(text)).toEqual([problem])
  })

  test('more than a million characters are not read, more than 500 stations not taken', () => {
    expect(problemsIn('x'.repeat(1_000_001))[0]!.kind).toBe('tooLarge')
    expect(problemsIn(svg(Array.from({ length: 501 }, (_, id) => node(id, id)).join('')))[0]!.kind).toBe(
      'tooManyStations',
    )
  })

  test('an entity that would blow up is not followed', () => {
    const bomb =
      `<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>` + svg(`<text>&b;</text>${two}`)
    expect(readMap(bomb).map).toBeNull()
  })

  test('whatever is cut, doubled or swapped in a map, it is read or refused', () => {
    const text = textOf('railway').replace(/<g id="scenery"[\s\S]*?<g id="roads"/, '<g id="roads"')
    const place = fc.nat(text.length)
    fc.assert(
      fc.property(place, place, fc.constantFrom('cut', 'double', 'swap'), (a, b, what) => {
        const [from, to] = [Math.min(a, b), Math.max(a, b)]
        const middle = text.slice(from, to)
        const other = { cut: '', double: middle + middle, swap: [...middle].toReversed().join('') }[what]
        const { map, problems } = readMap(text.slice(0, from) + other + text.slice(to))
        expect(map === null).toBe(problems.length > 0)
      }),
      { numRuns: 150 },
    )
  })
})

describe('own rewards', () => {
  const city: LearningOutline = {
    ...{
      blocks: { map: 'map' },
      map: 'city',
      start: 0,
      goal: 15,
      closed: [[16, 15]],
      episodes: 1e6,
      moves: 60_000,
    },
    settings: { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.9, rho: 0.9 },
  }
  const learned = (pay?: LearningOutline['pay']) => {
    const course = courseOf({ ...city, ...(pay && { pay }) }, mapOf('city'), 1)
    course.advance(city.moves)
    return { course, way: course.way().states! }
  }

  test('the City by length has a way of nine stations, by sections one of eight (spec, "Maps")', () => {
    const [bySections, byLength] = [learned(), learned({ length: true })]
    expect(bySections.way).toHaveLength(8)
    expect(byLength.way).toHaveLength(9)
    expect(isShortest(bySections.course, bySections.way)).toBe(true)
    expect(isShortest(byLength.course, byLength.way)).toBe(true)
    expect(isShortest(byLength.course, bySections.way)).toBe(false)
    expect(isShortest(bySections.course, byLength.way)).toBe(false)
  })

  test('a station that costs more than it brings is left aside', () => {
    const { way } = learned()
    const aside = learned({ own: { [way[4]!]: -40 } }).way
    expect(aside).not.toContain(way[4]!)
    expect(aside.at(-1)).toBe(15)
  })

  test('a road pays in its direction alone', () => {
    const { learner } = courseOf({ ...city, pay: { own: { '0-1': 7 }, step: 1 } }, mapOf('city'), 1)
    const { world } = learner
    const paid = (from: number, to: number) =>
      world.reward[Array.from(world.meant).findIndex((at, move) => at === to && world.from[move] === from)]
    expect([paid(0, 1), paid(1, 0), paid(14, 15)]).toEqual([6, -1, 49])
  })
})
