import { fastDraw, fastStream, stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  greedyPath,
  createLearner,
  gridMap,
  layOutWorld,
  learnWatching,
  policy,
  restoreLearner,
  run,
  saveLearner,
  shortestPath,
  step,
  type QState,
  type Settings,
  type Task,
} from './index.ts'

const usual: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }
const seeded = (seed = 1) => stream(seed, 'learn/test/1')
const learnerOf = (task: Task, settings: Partial<Settings> = {}) =>
  createLearner(layOutWorld(task), { ...usual, ...settings }, seeded())

const share = fc.double({ min: 0, max: 1, noNaN: true })
const anySettings: fc.Arbitrary<Settings> = fc.record({
  rules: fc.constantFrom('standard', 'study'),
  algorithm: fc.constantFrom('q', 'sarsa'),
  ...{ alpha: share, gamma: share, nu: share, rho: share },
  alphaDecay: fc.oneof(
    fc.constantFrom({ kind: 'constant' } as const, { kind: 'visits' } as const),
    share.map((factor) => ({ kind: 'episodes', factor }) as const),
  ),
  rhoDecay: share.map((factor) => ({ kind: 'episodes', factor }) as const),
})

/** Any map that is one: no roads, roads to themselves, slippery ones, rewards of any size. */
const anyTask: fc.Arbitrary<Task> = fc.integer({ min: 1, max: 12 }).chain((count) => {
  const state = fc.nat(count - 1)
  const reward = fc.oneof(fc.constant(0), fc.double({ min: -1e12, max: 1e12, noNaN: true }))
  const slippery = fc.tuple(state, state, reward).map(([a, b, paid]) => [
    { probability: 0.25, to: a },
    { probability: 0.75, to: b, reward: paid },
  ])
  const road = fc.record(
    { to: state, reward, length: fc.nat(1000), outcomes: slippery },
    { requiredKeys: ['to'] },
  )
  const roads = fc.array(road, { maxLength: 4 })
  return fc.record({
    map: fc.record({
      actions: fc.array(roads, { minLength: count, maxLength: count }),
      terminals: fc.array(state, { maxLength: 2 }),
    }),
    ...{ start: state, goal: state },
    closed: fc.array(fc.tuple(state, state), { maxLength: 3 }),
    ...{ goalReward: reward, stepCost: reward, lengthCost: fc.double({ min: 0, max: 10, noNaN: true }) },
  })
})

describe('on any map with any settings', () => {
  test('a move is one that is open, and its numbers are the update of the book (Sutton & Barto, 6.7 and 6.8)', () => {
    fc.assert(
      fc.property(anyTask, anySettings, (task, settings) => {
        const learner = learnerOf(task, settings)
        const { world } = learner
        for (let t = 1; t <= 60; t++) {
          const trace = step(learner)
          expect(trace.t).toBe(t)
          if (trace.decision === null) {
            expect(world.first[trace.from]).toBe(world.first[trace.from + 1])
            continue
          }
          expect(world.from[trace.action]).toBe(trace.from)
          const target = trace.reward + settings.gamma * trace.bestNext
          expect(trace.after).toBe((1 - trace.alpha) * trace.before + trace.alpha * target)
          expect(learner.q[trace.action]).toBe(trace.after)
        }
      }),
    )
  })

  test('a state that was saved as text goes on bit for bit the same (running.md 2)', () => {
    fc.assert(
      fc.property(anyTask, anySettings, fc.nat(80), (task, settings, steps) => {
        const learner = learnerOf(task, settings)
        run(learner, steps)
        const copy = learnerOf(task, settings)
        restoreLearner(copy, JSON.parse(JSON.stringify(saveLearner(learner))) as QState)
        const after = (one: typeof learner) => Array.from({ length: 40 }, () => step(one))
        expect(after(copy)).toEqual(after(learner))
        expect(saveLearner(copy)).toEqual(saveLearner(learner))
      }),
    )
  })

  test('many steps at once are the same as single ones', () => {
    fc.assert(
      fc.property(anyTask, anySettings, fc.nat(200), (task, settings, steps) => {
        const stepped = learnerOf(task, settings)
        const ran = learnerOf(task, settings)
        for (let t = 0; t < steps; t++) step(stepped)
        run(ran, steps)
        expect(saveLearner(ran)).toEqual(saveLearner(stepped))
      }),
    )
  })

  test('the best way is walked by open roads and ends where it says', () => {
    fc.assert(
      fc.property(anyTask, anySettings, (task, settings) => {
        const learner = learnerOf(task, settings)
        run(learner, 300)
        const way = greedyPath(learner)
        const walked = way.states ?? way.walked
        const best = policy(learner)
        for (const [index, state] of walked.slice(0, -1).entries())
          expect(learner.world.meant[best[state]!]).toBe(walked[index + 1])
        if (way.states) expect(walked.at(-1)).toBe(task.goal)
        else if (learner.goals === 0) expect(way.reason).toBe('neverReached')
        else if (way.reason === 'circle')
          expect(walked.indexOf(walked.at(-1)!)).toBeLessThan(walked.length - 1)
        else if (way.reason === 'deadEnd') expect(best[walked.at(-1)!]).toBe(-1)
      }),
    )
  })
})

describe('odd maps', () => {
  const line = (states: number): Task => ({
    map: {
      actions: Array.from({ length: states }, (_, from) => (from + 1 < states ? [{ to: from + 1 }] : [])),
    },
    ...{ start: 0, goal: states - 1 },
  })

  test('one station: it is there already', () => {
    const learner = learnerOf(line(1))
    run(learner, 10)
    expect(greedyPath(learner)).toEqual({ states: [0], reason: 'startIsGoal' })
  })

  test('500 stations in a row are learned', () => {
    const learner = learnerOf(line(500), { nu: 0.5 })
    run(learner, 600_000)
    expect(greedyPath(learner).states).toHaveLength(500)
  })

  test('all roads closed: it says that it never got to the goal', () => {
    const learner = learnerOf({
      ...line(3),
      closed: [
        [0, 1],
        [1, 2],
      ],
    })
    run(learner, 50)
    expect(greedyPath(learner)).toEqual({ states: null, reason: 'neverReached', walked: [0] })
    expect(step(learner)).toMatchObject({ decision: null, action: -1, ends: 'deadEnd', to: 0 })
  })

  test('a reward that lies on the way round invites to walk in circles', () => {
    const map = { actions: [[{ to: 1 }, { to: 2 }], [{ to: 0 }], []], rewards: { 1: 60 } }
    const learner = learnerOf({ map, start: 0, goal: 2 }, { gamma: 0.9 })
    run(learner, 5000)
    expect(greedyPath(learner)).toEqual({ states: null, reason: 'circle', walked: [0, 1, 0] })
  })

  test.each([
    [{ start: 3 }, 'The start is station 3; there are 0 to 2.'],
    [{ goal: -1 }, 'The goal is station -1; there are 0 to 2.'],
    [{ stepCost: NaN }, 'stepCost is NaN, not a number that counts.'],
    [{ goalReward: Infinity }, 'goalReward is Infinity, not a number that counts.'],
    [{ map: { actions: [] } }, 'A map has 1 to 10000 stations, not 0.'],
    [{ map: { actions: [[{ to: 7 }]] }, goal: 0 }, 'The end of Road 0-7 is station 7; there are 0 to 0.'],
    [
      { map: { actions: [[{ to: 0, reward: NaN }]] }, goal: 0 },
      'The reward of Road 0-0 is NaN, not a number that counts.',
    ],
    [{ map: { actions: [[{ to: 0, length: -1 }]] }, goal: 0 }, 'Road 0-0 has the length -1.'],
    [
      { map: { actions: [[{ to: 0 }]], rewards: { 0: NaN } }, goal: 0 },
      'The reward of station 0 is NaN, not a number that counts.',
    ],
    [
      {
        map: {
          actions: [
            [
              {
                to: 0,
                outcomes: [
                  { probability: -0.5, to: 0 },
                  { probability: 1.5, to: 0 },
                ],
              },
            ],
          ],
        },
        goal: 0,
      },
      'The probabilities of Road 0-0 add up to 1, not to 1.',
    ],
    [
      { map: { actions: [[{ to: 0, outcomes: [{ probability: 0.5, to: 0 }] }]] }, goal: 0 },
      'The probabilities of Road 0-0 add up to 0.5, not to 1.',
    ],
  ])('%j is refused with a word', (odd, words) => {
    expect(() => layOutWorld({ ...line(3), ...odd })).toThrow(new RangeError(words))
  })

  test.each(['alpha', 'gamma', 'nu', 'rho'])('%s has to be a number from 0 to 1', (name) => {
    for (const value of [NaN, -0.1, 1.1])
      expect(() => learnerOf(line(2), { [name]: value })).toThrow(
        new RangeError(`${name} is ${value}; it must be a number from 0 to 1.`),
      )
  })

  test('a state that has chosen a move which is not there is refused', () => {
    const state = { ...saveLearner(learnerOf(line(3))), chosen: 2 }
    expect(() => restoreLearner(learnerOf(line(3)), state)).toThrow('stands on a station that is not there')
    expect(() => restoreLearner(learnerOf(line(3)), { ...state, chosen: 1 })).not.toThrow()
  })

  test('a shortest way is counted in stations, along the roads of each station alone', () => {
    const roads = [[{ to: 1 }], [{ to: 2 }], [{ to: 3 }], []]
    const task = { map: { actions: roads }, start: 0, goal: 3 }
    expect(shortestPath(layOutWorld(task))).toBe(4)
    const shorter = [[{ to: 1 }, { to: 2 }], ...roads.slice(1)]
    expect(shortestPath(layOutWorld({ ...task, map: { actions: shorter } }))).toBe(3)
    expect(shortestPath(layOutWorld({ ...task, start: 3, goal: 0 }))).toBeNull()
  })

  test('a learner that has not moved has nothing to show of its last move', () => {
    const { last } = learnerOf(line(3))
    expect(last).toMatchObject({ from: 0, to: 0, action: -1, teleported: false, explores: false, ends: null })
    expect(last).toMatchObject({ reward: 0, before: 0, bestNext: 0, after: 0, alpha: 0 })
  })

  test('the two draws of a move are the first two of its stream', () => {
    const learner = learnerOf(line(3))
    const dice = fastStream(seeded())
    step(learner)
    expect([...learner.last.draws]).toEqual([fastDraw(dice), fastDraw(dice)])
  })

  test('a grid is walked to the left, down, to the right and up, in this order', () => {
    const { map } = gridMap(['FFF', 'FSF', 'FFG'])
    expect(map.actions[4]!.map(({ name }) => name)).toEqual(['left', 'down', 'right', 'up'])
  })

  test('a state of another map is refused', () => {
    const state = saveLearner(learnerOf(line(4)))
    expect(() => restoreLearner(learnerOf(line(3)), state)).toThrow(
      'This state knows 3 moves, the map has 2.',
    )
  })
})

describe('a grid', () => {
  test('is refused with a word where it is none', () => {
    expect(() => gridMap(['SF', 'G'])).toThrow('equally long')
    expect(() => gridMap(['SX', 'GF'])).toThrow('A grid has no cell X')
    expect(() => gridMap(['SF', 'FF'])).toThrow('one start S and one goal G')
  })

  test('has walls that nobody passes', () => {
    const { map } = gridMap(['SWG', 'FFF'])
    expect(map.actions[0]!.map(({ to }) => to)).toEqual([0, 3, 0, 0])
  })
})

describe('what falls', () => {
  const line: Task = { map: { actions: [[{ to: 1 }], [{ to: 2 }], []] }, start: 0, goal: 2 }
  const alphas = (settings: Partial<Settings>, steps: number) => {
    const learner = learnerOf(line, { nu: 0, ...settings })
    return Array.from({ length: steps }, () => step(learner).alpha)
  }

  test('with visits α is α · 10 / (9 + n) at the n-th update of a value', () => {
    // Each episode updates both values once.
    const rates = alphas({ alpha: 0.8, alphaDecay: { kind: 'visits' } }, 182).filter(
      (_, move) => move % 2 === 0,
    )
    expect([1, 2, 3, 11, 91].map((n) => rates[n - 1])).toEqual([0.8, 8 / 11, 8 / 12, 0.4, 0.08])
  })

  test('by episodes α and ρ are times their factor after each', () => {
    const rates = alphas({ alpha: 0.8, alphaDecay: { kind: 'episodes', factor: 0.5 } }, 6)
    expect(rates).toEqual([0.8, 0.8, 0.4, 0.4, 0.2, 0.2])
    const learner = learnerOf(line, { nu: 0, rho: 0.8, rhoDecay: { kind: 'episodes', factor: 0.5 } })
    run(learner, 6)
    expect(learner.epsilon).toBe(0.1)
  })
})

test('on the cliff SARSA takes the safe way and gets more while it learns (Sutton & Barto, example 6.6)', () => {
  const { map, start, goal } = gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], {
    cliffReward: -99,
  })
  const task = { map, start, goal, goalReward: 0, stepCost: 1 }
  const rewards = (['q', 'sarsa'] as const).map((algorithm) => {
    const learner = learnerOf(task, { algorithm, alpha: 0.5, gamma: 1, nu: 0, rho: 0.1 })
    let [sum, episodes] = [0, 0]
    while (learner.episodes < 500) {
      const before = learner.episodes
      const { reward } = step(learner)
      if (before >= 100) sum += reward
      if (before >= 100 && learner.episodes > before) episodes += 1
    }
    return sum / episodes
  })
  const [q, sarsa] = rewards as [number, number]
  expect(q).toBeGreaterThan(-75)
  expect(q).toBeLessThan(-35)
  expect(sarsa).toBeGreaterThan(-35)
  expect(sarsa).toBeLessThan(-15)
})

test('the first move with a shortest way is the one that looking after every move finds', () => {
  fc.assert(
    fc.property(anyTask, anySettings, (task, settings) => {
      const watched = learnerOf(task, settings)
      const looked = learnerOf(task, settings)
      const first = learnWatching(watched, 300)
      let wanted: number | null = null
      while (looked.steps < 300) {
        step(looked)
        if (greedyPath(looked).states?.length === shortestPath(looked.world)) wanted ??= looked.steps
      }
      expect(task.start === task.goal || first === wanted).toBe(true)
      expect(saveLearner(watched)).toEqual(saveLearner(looked))
    }),
  )
})
