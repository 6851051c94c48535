import { stream } from '@botgarten/numbers'
import { describe, expect, test } from 'vitest'
import {
  bestReturn,
  createLearner,
  expectedReturn,
  gridMap,
  layOutWorld,
  learnedPath,
  planOf,
  run,
  type Settings,
} from './index.ts'
import policies from './reference/policies.json' with { type: 'json' }
import worlds from './reference/worlds.json' with { type: 'json' }

const third = { surefooted: 1 / 3 }
const lake = { grid: gridMap(['SFFF', 'FHFH', 'FFFH', 'HFFG'], third), pay: { goalReward: 1 } }
const lake8 = gridMap(
  ['SFFFFFFF', 'FFFFFFFF', 'FFFHFFFF', 'FFFFFHFF', 'FFFHFFFF', 'FHHFFFHF', 'FHFFHFHF', 'FFFHFFFG'],
  third,
)
const cliff = gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], { cliffReward: -99 })
const given = {
  lake4: { ...lake, order: [0, 1, 2, 3] },
  lake8: { grid: lake8, pay: { goalReward: 1 }, order: [0, 1, 2, 3] },
  // Its actions are up, right, down, left.
  cliff: { grid: cliff, pay: { goalReward: 0, stepCost: 1 }, order: [3, 2, 1, 0] },
} as const

describe.each(['lake4', 'lake8', 'cliff'] as const)("on Gymnasium's %s", (name) => {
  const { grid, pay, order } = given[name]
  const world = layOutWorld({ map: grid.map, start: grid.start, goal: grid.goal, ...pay })
  const { gamma, q } = worlds[name]

  test.each(policies[name])('a policy expects what linear algebra says: $return', (theirs) => {
    const moves = theirs.policy.map((action, state) => {
      const first = world.first[state]!
      return world.first[state + 1] === first ? -1 : first + order[action]!
    })
    expect(Math.abs(expectedReturn(world, moves, gamma)! - theirs.return)).toBeLessThan(1e-9)
  })

  test('the largest return is the one of value iteration', () => {
    expect(Math.abs(bestReturn(world, gamma)! - Math.max(...q[grid.start]!))).toBeLessThan(1e-9)
  })
})

describe('on the slippery lake', () => {
  const world = layOutWorld({ map: lake.grid.map, start: lake.grid.start, goal: lake.grid.goal, ...lake.pay })
  const settings: Settings = {
    ...{ rules: 'standard', algorithm: 'q', alpha: 1, gamma: 0.95, nu: 0.5, rho: 1 },
    alphaDecay: { kind: 'visits' },
  }
  const learner = () => createLearner(world, settings, stream(1, 'learn/test/1'))

  test('a learned plan expects nearly what the best one does, and there is no way', () => {
    const one = learner()
    run(one, 2_000_000)
    const { doubt, expected, best, reaches, policy } = planOf(one)
    expect(doubt).toBeNull()
    expect(expected!).toBeGreaterThan(0.97 * best!)
    expect(expected!).toBeLessThanOrEqual(best! + 1e-12)
    // Of Gymnasium's best policy: 32 of 41.
    expect(Math.abs(reaches - policies.lake4[0]!.reaches)).toBeLessThan(0.06)
    expect(policy[15]).toBe(-1)
    expect(learnedPath(one)).toEqual({ states: null, reason: 'chance', walked: [0] })
  })

  test('where nothing is learned yet the plan is in doubt from the start on', () => {
    expect(planOf(learner())).toMatchObject({ doubt: 0, expected: 0, reaches: 0 })
  })

  test('what never ends and costs has no return', () => {
    const circle = layOutWorld({
      map: { actions: [[{ to: 1 }], [{ to: 0 }], []] },
      start: 0,
      goal: 2,
      stepCost: 1,
    })
    expect(expectedReturn(circle, [0, 1, -1], 1)).toBeNull()
    expect(bestReturn(circle, 0.5)).toBeCloseTo(-2, 12)
  })
})
