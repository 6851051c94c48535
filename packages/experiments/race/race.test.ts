import { gridMap, type Task } from '@botgarten/learning/q-learning'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { bandOf } from './bands.ts'
import {
  criteriaOn,
  heatsOf,
  limits,
  orderOf,
  pointsOf,
  raceOf,
  racers,
  resultOf,
  runLane,
  winnersOf,
  type Bill,
  type Lane,
  type Race,
} from './index.ts'
import reference from '../reference/cliff.json' with { type: 'json' }

const cliff = gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], { cliffReward: -99 })
const onCliff: Task = { ...cliff, goalReward: 0, stepCost: 1 }
const onIce: Task = gridMap(['SFF', 'FHF', 'HFG'], { surefooted: 1 / 3 })
const ring: Task = {
  map: { actions: [[{ to: 1 }, { to: 3 }], [{ to: 2 }, { to: 0 }], [{ to: 1 }, { to: 3 }], []] },
  ...{ start: 0, goal: 3 },
}
const usual = { alpha: 0.5, gamma: 0.8, nu: 0, rho: 0.1 }
const four: Lane[] = racers.map((racer) => ({ racer, ...usual }))

const share = fc.double({ min: 0, max: 1, noNaN: true })
const anyLane: fc.Arbitrary<Lane> = fc.record({
  racer: fc.constantFrom(...racers),
  ...{ alpha: share, gamma: share, nu: share, rho: share },
})
const anyRace: fc.Arbitrary<Race> = fc.record({
  task: fc.constantFrom(ring, onIce),
  lanes: fc.array(anyLane, { minLength: 2, maxLength: 4 }),
  ...{ tries: fc.integer({ min: 1, max: 130 }), runs: fc.integer({ min: 1, max: 7 }) },
  ...{ seed: fc.nat(), sameDice: fc.boolean() },
})

describe('a race', () => {
  it('is the same again, in one piece and in heats of any order', () => {
    fc.assert(
      fc.property(anyRace, (race) => {
        const whole = raceOf(race)
        const records = race.lanes.map(() => [] as ReturnType<typeof runLane>[])
        for (const { lane, runs } of heatsOf(race).toReversed())
          for (const run of runs) records[lane - 1]![run - 1] = runLane(race, lane, run)
        expect(records.map((all) => resultOf(all, race.tries))).toEqual(whole)
        expect(raceOf(race)).toEqual(whole)
      }),
      { numRuns: 25 },
    )
  })

  it('gives a lane its own dice: another lane beside it changes nothing, unless all throw the same', () => {
    const race: Race = { task: ring, lanes: [four[0]!, four[0]!], tries: 20, runs: 3, seed: 7 }
    const [first, second] = raceOf(race)
    expect(raceOf({ ...race, lanes: [...race.lanes, four[3]!] }).slice(0, 2)).toEqual([first, second])
    expect(second).not.toEqual(first)
    const [one, other] = raceOf({ ...race, sameDice: true })
    expect(one).toEqual(first)
    expect(other).toEqual(first)
  })

  it('has curves that never fall back, bands in order, and a bill that is the end of its curves', () => {
    fc.assert(
      fc.property(anyRace, (race) => {
        for (const { curves, ways, bill, runs } of raceOf(race)) {
          for (const name of ['moves', 'falls'] as const)
            curves[name].forEach(({ middle }, at, all) =>
              expect(middle).toBeGreaterThanOrEqual(all[at - 1]?.middle ?? 0),
            )
          for (const bands of Object.values(curves)) {
            expect(bands).toHaveLength(pointsOf(race.tries).length)
            for (const { low, middle, high } of bands)
              expect([low, middle, high]).toEqual([low, middle, high].toSorted((a, b) => a - b))
          }
          for (const name of ['moves', 'stars', 'falls'] as const)
            expect(bill[name]).toBe(curves[name].at(-1)!.middle)
          for (const then of ways) expect(then.reduce((sum, one) => sum + one.runs, 0)).toBe(runs)
          expect(bill.found).toBeLessThanOrEqual(runs)
        }
      }),
      { numRuns: 25 },
    )
  })

  it('refuses what is outside its limits by its name', () => {
    const race: Race = { task: ring, lanes: four, tries: 10, runs: 1, seed: 1 }
    const refused = (odd: Partial<Race>) => expect(() => raceOf({ ...race, ...odd }))
    refused({ lanes: four.slice(0, 1) }).toThrow('The number of lanes is 1; it goes from 2 to 8.')
    refused({ lanes: Array.from({ length: limits.lanes.most + 1 }, () => four[0]!) }).toThrow('lanes is 9')
    refused({ tries: 0 }).toThrow('The number of tries is 0')
    refused({ runs: 1.5 }).toThrow('The number of runs is 1.5')
    refused({ lanes: [four[0]!, { ...four[0]!, rho: 2 }] }).toThrow('rho of lane 2 is 2, not from 0 to 1.')
    refused({ lanes: [four[0]!, { ...four[0]!, racer: 'snail' as 'q' }] }).toThrow('no racer snail')
  })
})

describe('what counts', () => {
  it('are falls only where one can fall, and a good way only where moves lead where they are meant to', () => {
    expect(criteriaOn(onCliff)).toEqual(['way', 'stars', 'falls'])
    expect(criteriaOn(onIce)).toEqual(['stars', 'falls'])
    expect(criteriaOn(ring)).toEqual(['way', 'stars'])
  })

  it('sorts the bills and names every winner; nobody wins who found no way', () => {
    const bill: Bill = { tries: 9, moves: 90, stars: 10, falls: 3, first: 40, found: 5, reaches: null }
    const bills = [bill, { ...bill, first: null, falls: 1 }, { ...bill, stars: 12, first: 30 }]
    expect(winnersOf(bills, 'way')).toEqual([2])
    expect(winnersOf(bills, 'falls')).toEqual([1])
    expect(winnersOf(bills, 'stars')).toEqual([2])
    expect(orderOf(bills, 'way')).toEqual([2, 0, 1])
    expect(winnersOf([bill, bill], 'falls')).toEqual([0, 1])
    expect(winnersOf([{ ...bill, first: null }], 'way')).toEqual([])
  })
})

describe('curves', () => {
  it('have a point a try, or the first and a hundred in equal steps', () => {
    expect(pointsOf(3)).toEqual([1, 2, 3])
    expect(pointsOf(10_000).slice(0, 3)).toEqual([1, 100, 200])
    expect(pointsOf(10_000)).toHaveLength(101)
    expect(pointsOf(130).at(-1)).toBe(130)
  })

  it('have a pace of moves a try, also where many tries lie between two points', () => {
    const points = pointsOf(1000)
    const zeros = points.map(() => 0)
    const ways = points.map(() => ({ states: [0, 1] }))
    // Nine moves in the first try, then four in each.
    const moves = points.map((tries) => 9 + 4 * (tries - 1))
    const record = { moves, stars: zeros, falls: zeros, ways, first: null, reaches: null }
    const pace = resultOf([record], 1000).curves.pace.map(({ middle }) => middle)
    expect(pace).toEqual(points.map((_, at) => (at === 0 ? 9 : 4)))
  })

  it('have the quartiles that NumPy gives: percentile([1, 2, 4, 8, 9, 20], [25, 50, 75])', () => {
    expect(bandOf([9, 1, 20, 4, 2, 8])).toEqual({ low: 2.5, middle: 6, high: 8.75 })
    expect(bandOf([1, Infinity, Infinity])).toEqual({ low: Infinity, middle: Infinity, high: Infinity })
  })
})

describe('on the cliff', () => {
  /** Mean a try and its standard error in each of ten blocks of 50 tries. */
  const blocksOf = (series: 'stars' | 'falls', lane: Lane, runs: number) => {
    const race: Race = { task: onCliff, lanes: [lane, lane], tries: reference.episodes, runs, seed: 5 }
    const points = pointsOf(race.tries)
    const sums = Array.from({ length: runs }, (_, run) => runLane(race, 1, run + 1)[series])
    return Array.from({ length: reference.blocks }, (_, block) => {
      const upTo = (tries: number) => (values: readonly number[]) =>
        tries === 0 ? 0 : values[points.indexOf(tries)]!
      const means = sums.map((all) => (upTo(50 * (block + 1))(all) - upTo(50 * block)(all)) / 50)
      const mean = means.reduce((sum, one) => sum + one, 0) / runs
      const spread = means.reduce((sum, one) => sum + (one - mean) ** 2, 0) / (runs - 1)
      return { mean, error: Math.sqrt(spread / runs) }
    })
  }

  it.each(['q', 'sarsa'] as const)(
    'returns and falls of %s are those of an independent NumPy loop',
    (racer) => {
      const lane: Lane = { racer, alpha: 0.5, gamma: 1, nu: 0, rho: 0.1 }
      for (const [series, theirs] of [
        ['stars', reference[racer].returns],
        ['falls', reference[racer].falls],
      ] as const)
        blocksOf(series, lane, 150).forEach(({ mean, error }, block) => {
          const apart = Math.abs(mean - theirs.mean[block]!) / Math.hypot(error, theirs.error[block]!)
          expect(apart, `${series}, block ${block + 1}`).toBeLessThan(4.5)
        })
    },
  )

  it('SARSA falls less often and walks away from the edge; Q walks along it (Sutton & Barto, example 6.6)', () => {
    const lanes = (['q', 'sarsa'] as const).map((racer) => ({ racer, alpha: 0.5, gamma: 1, nu: 0, rho: 0.1 }))
    const [q, sarsa] = raceOf({ task: onCliff, lanes, tries: 500, runs: 20, seed: 1 })
    expect(sarsa!.bill.falls).toBeLessThan(q!.bill.falls / 2)
    expect(sarsa!.bill.stars).toBeGreaterThan(q!.bill.stars)
    expect(q!.ways.at(-1)![0]).toMatchObject({ states: { length: 14 } })
    const [safe] = sarsa!.ways.at(-1)!.filter((way) => 'states' in way)
    expect(safe!.states.length).toBeGreaterThan(14)
    expect(safe!.states.filter((state) => state >= 24 && state < 36).length).toBeLessThan(5)
  })
})
