import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  bestOf,
  cluster,
  LARGEST,
  distancesOf,
  plusPlusStart,
  pointsOf,
  randomStart,
  startAt,
  stepOne,
  stepPhase,
  type Distance,
} from './index.ts'
import reference from './reference/clusterings.json' with { type: 'json' }

const seeded = (seed = 1) => stream(seed, 'learn/k-means/1')
const distances: readonly Distance[] = ['euclidean', 'manhattan', 'cosine']

const numbered = <Row>(rows: readonly Row[]) => rows.map((row, index) => ({ ...row, index }))

describe('beside scikit-learn, with the same start, where no group is ever empty', () => {
  test.each(numbered(reference.scikit))('data set $index', (row) => {
    const found = cluster(pointsOf(row.points), row.start)
    expect(found.labels).toEqual(row.labels)
    expect(found.iterations).toBe(row.iterations)
    found.centres.forEach((centre, group) =>
      centre.forEach((value, feature) =>
        expect(Math.abs(value - row.centres[group]![feature]!)).toBeLessThan(1e-9),
      ),
    )
    expect(Math.abs(found.inertia.at(-1)! - row.inertia)).toBeLessThan(1e-9 * Math.max(1, row.inertia))
  })

  test('there are a hundred of them', () => expect(reference.scikit).toHaveLength(100))
})

describe('beside the obvious loop of the rules, to the last bit', () => {
  test.each(numbered(reference.empty))('with an empty group, data set $index', (row) => {
    const { points, start, distance, index: _, ...answer } = row
    expect(cluster(pointsOf(points), start, distance as Distance)).toEqual(answer)
  })

  test.each(numbered(reference.others))('$distance, data set $index', (row) => {
    const { points, start, distance, index: _, ...answer } = row
    expect(cluster(pointsOf(points), start, distance as Distance)).toEqual(answer)
  })
})

const value = fc.integer({ min: -1e6, max: 1e6 }).map((thousandths) => thousandths / 1000)
const anySet = fc
  .tuple(fc.integer({ min: 1, max: 4 }), fc.constantFrom(...distances))
  .chain(([features, distance]) =>
    fc.record({
      rows: fc.array(fc.array(value, { minLength: features, maxLength: features }), {
        minLength: 1,
        maxLength: 25,
      }),
      distance: fc.constant(distance),
      share: fc.double({ min: 0, max: 0.999, noNaN: true }),
    }),
  )
  .map(({ rows, distance, share }) => ({
    points: pointsOf(rows),
    distance,
    groups: 1 + Math.floor(share * Math.min(rows.length, 6)),
  }))

test.each(distances)('the largest numbers that are taken have finite distances: %s', (distance) => {
  const sides = [-LARGEST, LARGEST]
  const rows = Array.from({ length: 4000 }, (_, at) =>
    Array.from({ length: 100 }, (_, bit) => sides[(at >> (bit % 12)) & 1]!),
  )
  for (const points of [pointsOf(rows), pointsOf(rows.map(([x, y]) => [x!, y!]))]) {
    const { inertia, centres } = bestOf(points, 3, { starts: 2, init: '++', distance, stream: seeded() })
    expect([...inertia, ...centres.flat()].every(Number.isFinite)).toBe(true)
  }
})

describe('on any points', () => {
  test('step by step and all at once end in the same groups', () => {
    fc.assert(
      fc.property(anySet, fc.nat(1000), ({ points, distance, groups }, seed) => {
        const start = randomStart(points, groups, seeded(seed))
        const wanted = cluster(points, start, distance)
        let state = startAt(points, start, distance)
        while (state.phase !== 'done' && state.round < wanted.iterations) state = stepPhase(points, state)
        expect(state.labels).toEqual(wanted.labels)
        expect(state.centres).toEqual(wanted.centres)
        expect(state.round).toBe(wanted.iterations)
      }),
    )
  })

  test.each([
    ['crowds on a grid, where many lie between two flags', fc.integer({ min: 0, max: 6 })],
    ['hardly apart', fc.integer({ min: 0, max: 9 }).map((few) => few * 1e-160)],
    ['far out', fc.integer({ min: 0, max: 9 }).map((few) => 1e9 + few * 1e-6)],
  ])('a plane has a quicker way to the same: %s', (_, place) => {
    const crowd = fc.array(fc.tuple(place, place), { minLength: 60, maxLength: 200 })
    fc.assert(
      fc.property(crowd, fc.integer({ min: 1, max: 7 }), fc.nat(1000), (rows, groups, seed) => {
        const points = pointsOf(rows)
        const start = randomStart(points, groups, seeded(seed))
        const wanted = cluster(points, start)
        let state = startAt(points, start)
        while (state.phase !== 'done' && state.round < wanted.iterations) state = stepPhase(points, state)
        const { labels, centres, inertia, round } = state
        expect({ labels, centres, inertia, iterations: round }).toEqual(wanted)
      }),
      { seed: 8, numRuns: 150 },
    )
  })

  test('point by point and flag by flag is the same as a phase at once', () => {
    fc.assert(
      fc.property(anySet, fc.nat(1000), fc.nat(30), ({ points, distance, groups }, seed, ahead) => {
        let one = startAt(points, randomStart(points, groups, seeded(seed)), distance)
        for (let operation = 0; operation < ahead; operation++) one = stepOne(points, one).state
        const wanted = stepPhase(points, one)
        const { phase, round } = one
        while (one.phase === phase && one.round === round && phase !== 'done')
          one = stepOne(points, one).state
        expect(one).toEqual(wanted)
      }),
    )
  })

  test('every point is with the centre nearest to it when it has ended', () => {
    fc.assert(
      fc.property(anySet, fc.nat(1000), ({ points, distance, groups }, seed) => {
        const { labels, centres } = cluster(points, randomStart(points, groups, seeded(seed)), distance)
        labels.forEach((label, point) => {
          const away = distancesOf(points, point, centres, distance)
          expect(away[label]!).toBeLessThanOrEqual(Math.min(...away) + 1e-9 * Math.max(1, ...away))
        })
      }),
    )
  })

  test('inertia never grows while no group is empty, for straight distances', () => {
    fc.assert(
      fc.property(anySet, fc.nat(1000), ({ points, groups }, seed) => {
        const { inertia } = cluster(points, randomStart(points, groups, seeded(seed)))
        inertia.slice(1).forEach((now, index) => {
          expect(now).toBeLessThanOrEqual(inertia[index]! * (1 + 1e-9) + 1e-9)
        })
      }),
    )
  })

  test('a trace says what was done: the least distance, the old place and the new one', () => {
    fc.assert(
      fc.property(anySet, fc.nat(1000), ({ points, distance, groups }, seed) => {
        let state = startAt(points, randomStart(points, groups, seeded(seed)), distance)
        for (let operation = 0; operation < 80 && state.phase !== 'done'; operation++) {
          const { state: after, trace } = stepOne(points, state)
          if (trace?.kind === 'assign') {
            expect(trace.distances[trace.label]).toBe(Math.min(...trace.distances))
            expect(after.labels[trace.point]).toBe(trace.label)
          } else {
            expect(after.centres[trace!.centre]).toEqual(trace!.to)
            expect(state.before[trace!.centre]).toEqual(trace!.from)
          }
          state = after
        }
      }),
    )
  })

  test('the best of several starts is no worse than each of them', () => {
    fc.assert(
      fc.property(anySet, ({ points, distance, groups }) => {
        for (const init of ['random', '++'] as const) {
          const best = bestOf(points, groups, { starts: 4, init, distance, stream: seeded() })
          const one = bestOf(points, groups, { starts: 1, init, distance, stream: seeded() })
          expect(best.inertia.at(-1)!).toBeLessThanOrEqual(one.inertia.at(-1)!)
        }
      }),
    )
  })
})

describe('starts', () => {
  const rows = [[0], [0], [1], [50], [51]]

  test('by chance take different points, as many as there are groups', () => {
    const taken = randomStart(pointsOf(rows), 5, seeded()).map(([x]) => x!)
    expect(taken.toSorted((a, b) => a - b)).toEqual([0, 0, 1, 50, 51])
  })

  test('k-means++ takes a far point far more often than a near one (Arthur & Vassilvitskii, 2007)', () => {
    let apart = 0
    for (let seed = 0; seed < 400; seed++) {
      const [a, b] = plusPlusStart(pointsOf(rows), 2, 'euclidean', seeded(seed)).map(([x]) => x!)
      if (a! < 10 !== b! < 10) apart++
    }
    expect(apart).toBeGreaterThan(395)
  })

  test('k-means++ starts among a million points, most of them equal', () => {
    const many = { values: new Float64Array(1e6), count: 1e6, features: 1 }
    many.values[5] = 1
    const start = plusPlusStart(many, 3, 'euclidean', seeded())
    expect(start.flat().toSorted()).toEqual([0, 0, 1])
  })

  test('equal points can all be centres', () => {
    const equal = pointsOf([
      [1, 1],
      [1, 1],
      [1, 1],
    ])
    expect(plusPlusStart(equal, 3, 'euclidean', seeded())).toHaveLength(3)
    expect(cluster(equal, randomStart(equal, 3, seeded())).inertia.at(-1)).toBe(0)
  })
})

describe('what a centre is', () => {
  const rows = [
    [0, 0],
    [2, 0],
    [10, 3],
  ]

  test.each([
    ['euclidean', [4, 1]],
    ['manhattan', [2, 0]],
  ] as const)('%s: the mean, or the median', (distance, centre) => {
    expect(cluster(pointsOf(rows), [[1, 1]], distance).centres).toEqual([centre])
  })

  test('cosine: the mean direction, however far out a point is', () => {
    const [[x, y]] = cluster(
      pointsOf([
        [3, 0],
        [0, 500],
      ]),
      [[1, 1]],
      'cosine',
    ).centres as [[number, number]]
    expect(x).toBeCloseTo(y, 12)
  })
})

test.each([
  [() => pointsOf([]), 'There are no points.'],
  [() => pointsOf([[1], [1, 2]]), 'Point 1 has 2 features, the others have 1.'],
  [() => pointsOf([[1, NaN]]), 'Feature 1 of point 0 is NaN, not a number that counts.'],
  [() => randomStart(pointsOf([[1]]), 0, seeded()), 'There are 0 groups; one is the least.'],
  [() => randomStart(pointsOf([[1]]), 2, seeded()), '2 groups need as many points; there are 1.'],
  [() => cluster(pointsOf([[1]]), [[1], [2]]), '2 groups need as many points; there are 1.'],
  [() => pointsOf([[-1e141]]), 'Feature 0 of point 0 is -1e+141; 1e+140 is the most.'],
  [() => cluster(pointsOf([[1]]), [[1e141]]), 'A centre is farther out than 1e+140, which is the most.'],
  [() => cluster(pointsOf([[1]]), [[1, 2]]), 'A centre has 1 numbers, as the points have.'],
])('nonsense is refused with a word: %s', (act, words) => {
  expect(act).toThrow(new RangeError(words))
})
