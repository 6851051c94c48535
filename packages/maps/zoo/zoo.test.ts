import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { bestMoves, circleOf, isMended, offered, outcomeOf, provedOf, settingsOf, walkOf, worldOf, type Cage } from './index.ts' // prettier-ignore

/** A line of four stations: 0 to the goal 3, and back. */
const line = {
  map: { actions: [[{ to: 1 }], [{ to: 0 }, { to: 2 }], [{ to: 1 }, { to: 3 }], [{ to: 2 }]] },
}
const cage: Cage = {
  ...{ id: 'line', start: 0, goal: 3, wish: {}, solution: 0 },
  pay: [
    { for: 'station', station: 2, reward: 20 },
    { for: 'goal', reward: 50 },
  ],
  mend: { rule: 0, least: 0, most: 30, step: 10 },
  claim: { aLot: 'never', aLittle: 'wish' },
  setting: { alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5, episodes: 100 },
  source: { by: '', year: 2016, title: '', in: '' },
}
const rewardsWith = (pay: Cage['pay'], gamma = 0.8, more: Partial<Cage> = {}) => [
  ...worldOf({ ...cage, ...more, pay, mend: { options: [{ id: 'one', pay }] } }, line, 0, gamma).reward,
]

describe('a pay', () => {
  // Actions: 0-1 1-0 1-2 2-1 2-3 3-2
  test.each<[string, Cage['pay'], readonly number[]]>([
    ['the goal', [{ for: 'goal', reward: 50 }], [0, 0, 0, 0, 50, 0]],
    ['a station', [{ for: 'station', station: 1, reward: 7 }], [7, 0, 0, 7, 0, 0]],
    ['each move', [{ for: 'move', reward: -2 }], [-2, -2, -2, -2, -2, -2]],
    ['a road', [{ for: 'road', from: 1, to: 2, reward: 4 }], [0, 0, 4, 0, 0, 0]],
    [
      'a road in both directions',
      [{ for: 'road', from: 1, to: 2, both: true, reward: 4 }],
      [0, 0, 4, 4, 0, 0],
    ],
    ['moves away', [{ for: 'away', from: 0, reward: 5 }], [5, 0, 5, 0, 5, 0]],
    ['nearness', [{ for: 'nearer', reward: 10, back: 'nothing' }], [10, 0, 10, 0, 10, 0]],
    ['nearness, given back', [{ for: 'nearer', reward: 10, back: 'same' }], [10, -10, 10, -10, 10, -10]],
    // γΦ(s′) − Φ(s) with Φ = −10 · distance: from 3 moves away to 2 it is 30 − 0.8 · 20.
    ['nearness, exactly', [{ for: 'nearer', reward: 10, back: 'exact' }], [14, -4, 12, -6, 10, -8]],
  ])('for %s', (_, pay, rewards) => {
    rewardsWith(pay).forEach((reward, action) => expect(reward).toBeCloseTo(rewards[action]!, 12))
  })
})

test('a setting that costs is paid as its negative, and 0 costs nothing', () => {
  const costly: Cage = { ...cage, mend: { rule: 0, least: 0, most: 2, step: 1, costs: true } }
  // Actions 1-2 and 3-2 lead to the station with the rule.
  const paid = [0, 1, 2].map((setting) => {
    const { reward } = worldOf(costly, line, setting, 0.8)
    return [reward[2], reward[5]]
  })
  expect(paid).toEqual([
    [0, 0],
    [-1, -1],
    [-2, -2],
  ])
})

test('a shop that pays again and again is worth more than a goal that pays once', () => {
  expect(provedOf(cage, line, 30)).toEqual({ aLot: 'never', aLittle: 'wish' })
  const world = worldOf(cage, line, 30, offered.aLot)
  const moves = bestMoves(world, offered.aLot)
  expect(circleOf(world, moves)).toEqual([1, 2])
  expect(walkOf(world, moves, 5)).toEqual([0, 1, 2, 1, 2, 1])
  // Beside the shop the goal brings 50 at once, and the shop 0.8 · 20 / (1 − 0.64) = 44.4: of 0, 10, 20 and 30 the last one cheats.
  expect(settingsOf(cage.mend).map((setting) => isMended(cage, line, setting))).toEqual([
    true,
    true,
    true,
    false,
  ])
})

test('behaviours that are worth the same and come to different outcomes are a tie', () => {
  // At the station before the goal, a shop that pays 22.5 is worth 0.8 · 22.5 / 0.36 = 50, as much as the goal.
  expect(provedOf(cage, line, 22.5)).toEqual({ aLot: 'tie', aLittle: 'wish' })
  expect(isMended(cage, line, 22.5)).toBe(false)
})

test('a wish names stations to pass, and moves at most', () => {
  const world = worldOf(cage, line, 0, offered.aLot)
  const moves = bestMoves(world, offered.aLot)
  expect(outcomeOf(world, moves, { passes: [1, 2], moves: 3 })).toBe('wish')
  expect(outcomeOf(world, moves, { moves: 2 })).toBe('other')
  expect(outcomeOf(world, [[1], [2], [1, 3], []], {})).toBe('other')
})

/** A ring of stations, so that the goal can always be reached, with roads across. */
const ringWithRoads = fc.integer({ min: 3, max: 9 }).chain((stations) => {
  const others = fc.uniqueArray(fc.integer({ min: 0, max: stations - 1 }), { maxLength: 3 })
  return fc
    .array(others, { minLength: stations, maxLength: stations })
    .map((roads) =>
      roads.map((list, from) =>
        [...new Set([(from + 1) % stations, ...list])].filter((to) => to !== from).map((to) => ({ to })),
      ),
    )
})

test('exact closeness changes no best behaviour, on any map (Ng, Harada, Russell 1999, theorem 1)', () => {
  const some = fc.constantFrom(...Object.values(offered))
  fc.assert(
    fc.property(ringWithRoads, some, fc.integer({ min: 1, max: 60 }), (actions, gamma, reward) => {
      const goal = actions.length - 1
      const best = (pay: Cage['pay']) => {
        const paid = { ...cage, goal, pay, mend: { options: [{ id: 'one', pay }] } }
        return bestMoves(worldOf(paid, { map: { actions } }, 0, gamma), gamma).slice(0, goal)
      }
      const goalPays = { for: 'goal', reward: 50 } as const
      expect(best([goalPays, { for: 'nearer', reward, back: 'exact' }])).toEqual(best([goalPays]))
    }),
    { numRuns: 100 },
  )
})
