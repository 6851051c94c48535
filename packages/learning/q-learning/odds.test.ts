import { stream } from '@botgarten/numbers'
import { describe, expect, test } from 'vitest'
import { createLearner, greedyPath, layOutWorld, planOf, run, type Settings, type Task } from './index.ts'

const settings: Settings = {
  ...{ rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
}
const learn = (task: Task, moves = 5000) => {
  const learner = createLearner(layOutWorld(task), settings, stream(1, 'learn/odds'))
  run(learner, moves)
  return learner
}
/** 0 — 1 — 2 — 3, in both directions. */
const row = [[{ to: 1 }], [{ to: 0 }, { to: 2 }], [{ to: 1 }, { to: 3 }], [{ to: 2 }]]

describe('several goals', () => {
  test('each of them pays and ends an attempt, and the nearest is walked to', () => {
    const learner = learn({ map: { actions: row, goals: [0] }, start: 1, goal: 3 })
    expect([...learner.world.terminal]).toEqual([1, 0, 0, 1])
    expect(greedyPath(learner)).toMatchObject({ reason: 'found', states: [1, 0] })
    expect(learner.goals).toBe(learner.episodes)
  })

  test('goals that end nothing pay again and again, until the limit of an attempt', () => {
    const learner = learn({ map: { actions: row, endless: true }, start: 0, goal: 3 })
    expect(learner.goals).toBeGreaterThan(learner.episodes)
    expect(learner.steps).toBeGreaterThanOrEqual(80 * learner.episodes)
    // 50 every second move: 50 / (1 − 0.8²), reached when γ is 0.8.
    expect(Math.max(...learner.q)).toBeCloseTo(50 / (1 - 0.8 * 0.8), 3)
  })
})

describe('a slippery road', () => {
  const fork = (slip: number): Task['map'] => ({
    actions: [
      [
        { to: 1, slip, reward: 1 },
        { to: 2, reward: 2 },
        { to: 3, reward: 3 },
      ],
      [],
      [],
      [],
    ],
  })
  const oddsOf = (task: Task) => {
    const { to, upTo, outcome, reward } = layOutWorld(task)
    return Array.from({ length: outcome[1]! }, (_, end) => [
      to[end]!,
      Number((upTo[end]! - (upTo[end - 1] ?? 0)).toFixed(12)),
      reward[end]!,
    ])
  }

  test('is taken with 1 − p, and each other open one alike; the road that is taken pays', () => {
    const task = { map: fork(0.2), start: 0, goal: 3 }
    expect(oddsOf(task)).toEqual([
      [1, 0.8, 1],
      [2, 0.1, 2],
      [3, 0.1, 53],
    ])
    expect(oddsOf({ ...task, closed: [[0, 2]] })).toEqual([
      [1, 0.8, 1],
      [3, 0.2, 53],
    ])
  })

  test('without another open road is a sure one, and draws nothing', () => {
    const closed = [[0, 2], [0, 3]] as const // prettier-ignore
    expect(layOutWorld({ map: fork(0.2), start: 0, goal: 1, closed }).isSlippery).toBe(false)
  })

  test('makes the policy worth what its odds say', () => {
    const actions = [[{ to: 1, slip: 0.5 }, { to: 2 }], [], []]
    const plan = planOf(learn({ map: { actions }, start: 0, goal: 1 }, 2000))
    // The sure road ends beside the goal; of 1 and 2 the slippery one reaches it every second time.
    expect(plan).toMatchObject({ best: 25, expected: 25, reaches: 0.5 })
  })

  test('slips with a probability and nothing else', () => {
    expect(() => layOutWorld({ map: fork(1.5), start: 0, goal: 1 })).toThrow('slips with probability 1.5')
  })
})
