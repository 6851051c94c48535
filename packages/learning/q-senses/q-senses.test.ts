import { readFileSync } from 'node:fs'
import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  bestAction,
  bucketOf,
  bucketsOf,
  chooseAction,
  emptyTable,
  isOf,
  learn,
  learner,
  payFor,
  payKinds,
  problemOf,
  rhoAt,
  stateOf,
  statesOf,
  type Facts,
  type Settings,
  type SmallWorld,
  type Trial,
} from './index.ts'

const { world, values } = JSON.parse(
  readFileSync(new URL('reference/corridor.json', import.meta.url), 'utf8'),
) as { world: SmallWorld; values: { [gamma: string]: number[][] } }

/** Two eyes near, middle, far, and the bump. */
const eyes: Trial = {
  sensors: [
    { port: '2', mode: 'distance' },
    { port: '3', mode: 'distance' },
  ],
  edges: [
    [15, 40],
    [15, 40],
  ],
  bump: true,
  actions: [
    { left: 50, right: 50 },
    { left: -25, right: 25 },
    { left: 25, right: -25 },
  ],
  pay: [{ for: 'bump', coins: -5 }],
  ...{ hold: 15, bumpEnds: false, alpha: 0.2, gamma: 0.9, rho: 0.2, seed: 1 },
}

describe('buckets', () => {
  test('three of each eye and the bump are ten states', () => {
    expect(statesOf(eyes)).toBe(10)
    expect(stateOf(eyes, [14.9, 15], false)).toBe(1)
    expect(stateOf(eyes, [100, 39.9], false)).toBe(7)
    expect(stateOf(eyes, [100, 100], true)).toBe(9)
    expect(bucketsOf(eyes, 7)).toEqual([2, 1])
    expect(bucketsOf(eyes, 9)).toBeNull()
  })

  test('every reading falls into one bucket, and every state is made of its buckets', () => {
    const edges = fc
      .uniqueArray(fc.integer({ min: 1, max: 99 }), { maxLength: 4 })
      .map((list) => list.sort((a, b) => a - b))
    fc.assert(
      fc.property(
        fc.array(edges, { minLength: 1, maxLength: 3 }),
        fc.boolean(),
        fc.nat(),
        (all, bump, pick) => {
          const trial = { edges: all, bump }
          const state = pick % statesOf(trial)
          const buckets = bucketsOf(trial, state)
          const readings = buckets?.map((bucket, k) => (bucket === 0 ? 0 : all[k]![bucket - 1]!)) ?? []
          expect(stateOf(trial, readings, buckets === null)).toBe(state)
          buckets?.forEach((bucket, k) => expect(bucketOf(readings[k]!, all[k]!)).toBe(bucket))
        },
      ),
    )
  })
})

test('a table is of a trial where everything that decides what is learned is the same', () => {
  const table = { ...eyes, kind: 'table' as const, ...emptyTable(10, 3) }
  expect(isOf(eyes, table)).toBe(true)
  const others: Partial<Trial>[] = [
    { seed: 2 },
    { starts: [{ x: 1, y: 2 }] },
    { actions: eyes.actions.map((action) => ({ ...action, lamp: 'red' as const })) },
    { pay: [{ for: 'bump', coins: -6 }] },
    { bumpEnds: true },
  ]
  for (const other of others) expect(isOf({ ...eyes, ...other }, table)).toBe(false)
})

describe('pay', () => {
  const none = Object.fromEntries(payKinds.map((kind) => [kind, 0])) as Facts

  test('adds up sentence by sentence', () => {
    const pay = [
      { for: 'ahead', coins: 0.25 },
      { for: 'bump', coins: -5 },
    ] as const
    expect(payFor(pay, { ...none, ahead: 4, bump: 1 })).toBe(-4)
    expect(payFor([], { ...none, ahead: 4 })).toBe(0)
  })

  test.each([
    ['tryNoSenses', { sensors: [], edges: [] }],
    ['tryManySenses', { sensors: [...eyes.sensors, ...eyes.sensors] }],
    [
      'tryManyStates',
      {
        edges: [
          [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14],
          eyes.edges[0]!.concat(50, 60, 70, 80, 90, 91, 92, 93, 94, 95, 96),
        ],
      },
    ],
    ['tryNoActions', { actions: [{ left: 0, right: 0 }] }],
    ['tryManyActions', { actions: Array.from({ length: 13 }, (_, left) => ({ left, right: 0 })) }],
    ['tryNoPay', { pay: [{ for: 'bump', coins: 0 }] }],
    ['tryNoPay', { pay: [] }],
    ['tryManySentences', { pay: Array.from({ length: 7 }, () => ({ for: 'bump' as const, coins: 1 })) }],
  ] as const)('%s is said before it tries', (problem, part) => {
    expect(problemOf({ ...eyes, ...part })).toBe(problem)
    expect(problemOf(eyes)).toBeNull()
  })
})

describe('learning', () => {
  test.each([0, 0.5, 0.9])('comes to the values of value iteration in a corridor, γ %s', (gamma) => {
    const settings: Settings = { alpha: 0.5, gamma, rho: 1, fall: 1_000_000 }
    const state = learner.begin(settings, world, stream(1, 'learn/corridor'))
    for (let step = 0; step < 20_000; step++) learner.step(state)
    closeTo(valuesOf(state), values[gamma]!)
  })

  test('comes to them with an α that falls by visits', () => {
    const settings: Settings = { alpha: 1, gamma: 0.5, rho: 1, fall: 1_000_000, alphaDecay: 'visits' }
    const state = learner.begin(settings, world, stream(2, 'learn/corridor'))
    for (let step = 0; step < 60_000; step++) learner.step(state)
    closeTo(valuesOf(state), values['0.5']!)
  })

  test('is equal to a literal loop, bit for bit', () => {
    const share = fc.double({ min: 0, max: 1, noNaN: true })
    const move = fc.record({
      from: fc.nat({ max: 4 }),
      action: fc.nat({ max: 2 }),
      reward: fc.double({ min: -100, max: 100, noNaN: true }),
      to: fc.nat({ max: 4 }),
      ends: fc.boolean(),
    })
    fc.assert(
      fc.property(share, share, fc.array(move, { maxLength: 60 }), (alpha, gamma, moves) => {
        const table = emptyTable(5, 3)
        const literal = Array.from({ length: 5 }, () => [0, 0, 0])
        for (const one of moves) {
          learn(table, 3, { alpha, gamma, rho: 0, fall: 1 }, one)
          const { from, action, reward, to, ends } = one
          const target = reward + gamma * (ends ? 0 : Math.max(...literal[to]!))
          literal[from]![action] = (1 - alpha) * literal[from]![action]! + alpha * target
        }
        expect(table.q).toEqual(literal.flat())
        expect(table.moves).toBe(moves.length)
      }),
    )
  })

  test('explores less and less, down to 0.3 of what it began with', () => {
    const settings: Settings = { alpha: 0.2, gamma: 0.9, rho: 0.2, fall: 1920 }
    expect(rhoAt(settings, 0)).toBe(0.2)
    expect(rhoAt(settings, 960)).toBeCloseTo(0.13, 12)
    expect(rhoAt(settings, 1920)).toBeCloseTo(0.06, 12)
    expect(rhoAt(settings, 1e6)).toBeCloseTo(0.06, 12)
  })

  test('takes each of several best actions equally often, and without exploring none but them', () => {
    const draws = stream(3, 'ties')
    const counts = [0, 0, 0, 0]
    for (let k = 0; k < 3000; k++) counts[bestAction([9, 9, 9, 9, 1, 5, 5, 5], 1, 4, draws)]!++
    expect(counts[0]).toBe(0)
    for (const count of counts.slice(1)) expect(Math.abs(count - 1000)).toBeLessThan(100)
    expect(chooseAction([0, 2, 1], 0, 3, 0, draws)).toEqual({ action: 1, explores: false })
  })
})

const valuesOf = (state: Parameters<typeof learner.save>[0]): number[] => [...learner.save(state).q]

function closeTo(found: readonly number[], expected: readonly (readonly number[])[]): void {
  expected.flat().forEach((value, k) => expect(Math.abs(found[k]! - value)).toBeLessThan(1e-6))
}
