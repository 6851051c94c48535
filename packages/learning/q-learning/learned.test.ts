import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  bestActions,
  greedyPath,
  Course,
  createLearner,
  gridMap,
  layOutWorld,
  learnedPath,
  run,
  type QLearner,
  type Settings,
  type Task,
} from './index.ts'
import { randomTask } from './testing/textbook.ts'

const usual: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }
const learnerOf = (task: Task, settings: Partial<Settings> = {}, seed = 1) =>
  createLearner(layOutWorld(task), { ...usual, ...settings }, stream(seed, 'learn/test/1'))

/** The Railway of the first card; no road is closed. */
const roads = [[1, 5], [0, 2], [1, 3], [2, 4, 5], [3, 5], [0, 3, 4]] // prettier-ignore
const railway: Task = {
  ...{ map: { actions: roads.map((list) => list.map((to) => ({ to }))) }, start: 3, goal: 1 },
}

/** Sets what a learner knows: by road its value and how often it was tried. */
function knows(learner: QLearner, known: { readonly [road: string]: readonly [q: number, tries: number] }) {
  for (const [road, [q, tries]] of Object.entries(known)) {
    const move = learner.world.names.indexOf(road)
    learner.q[move] = q
    learner.tries[move] = tries
  }
  learner.goals = 1
  return learner
}

describe('a way is learned', () => {
  test('where the best road of each of its stations was tried, is worth something, and no untried one as much', () => {
    const learner = knows(learnerOf(railway), { '3-2': [20, 2], '2-1': [25, 1] })
    expect(learnedPath(learner)).toEqual({ states: [3, 2, 1], reason: 'found' })
  })

  test('not where all roads are still worth 0 and only the lowest number has won: after one try', () => {
    const learner = knows(learnerOf(railway), { '3-2': [0, 1], '2-1': [25, 1] })
    expect(greedyPath(learner).states).toEqual([3, 2, 1])
    expect(learnedPath(learner)).toEqual({ states: null, reason: 'alike', walked: [3] })
  })

  test('not where it walks in a circle between stations whose roads are all worth 0', () => {
    const learner = knows(learnerOf({ ...railway, closed: [[3, 2], [2, 3]] }), { '3-4': [0, 1], '3-5': [0, 2], '4-3': [0, 1] }) // prettier-ignore
    expect(greedyPath(learner)).toMatchObject({ reason: 'circle' })
    expect(learnedPath(learner)).toEqual({ states: null, reason: 'alike', walked: [3] })
  })

  test('where the first of two equal roads leads in a circle and the other one to the goal', () => {
    const learner = knows(learnerOf(railway), { '3-2': [20, 1], '2-1': [20, 1], '2-3': [20, 1] })
    const tied = knows(learnerOf(railway), { '3-4': [20, 1], '4-3': [20, 1], '3-5': [20, 1], '5-0': [20, 1], '0-1': [20, 1] }) // prettier-ignore
    expect(learnedPath(learner)).toEqual({ states: [3, 2, 1], reason: 'found' })
    expect(greedyPath(tied)).toMatchObject({ reason: 'circle' })
    expect(learnedPath(tied)).toEqual({ states: [3, 5, 0, 1], reason: 'found' })
    expect(bestActions(tied, 3).map((action) => tied.world.names[action])).toEqual(['3-4', '3-5'])
  })

  test('by the first of two equal roads, which is the one that is shown, also where the other one is shorter', () => {
    const learner = knows(learnerOf(railway), { '3-4': [20, 1], '4-5': [20, 1], '3-5': [20, 1], '5-0': [20, 1], '0-1': [20, 1] }) // prettier-ignore
    expect(learnedPath(learner)).toEqual({ states: [3, 4, 5, 0, 1], reason: 'found' })
  })

  test('not where the only best road leads in a circle', () => {
    const learner = knows(learnerOf(railway), { '3-4': [20, 1], '4-3': [20, 1], '3-5': [19, 1], '5-0': [20, 1], '0-1': [20, 1] }) // prettier-ignore
    expect(learnedPath(learner)).toMatchObject({ states: null, reason: 'circle' })
  })

  test('not where every road that was tried costs and one was never tried', () => {
    const known = { '3-2': [-1, 1], '3-5': [-2, 3], '2-1': [25, 1] } as const
    expect(learnedPath(knows(learnerOf(railway), known))).toMatchObject({ reason: 'untried', walked: [3] })
  })

  test('not where the best road that was tried is worth 0 and others cost', () => {
    const known = { '3-2': [0, 1], '3-4': [-5, 1], '3-5': [-5, 1], '2-1': [25, 1] } as const
    expect(learnedPath(knows(learnerOf(railway), known))).toMatchObject({ reason: 'unpaid', walked: [3] })
  })

  test('not where nothing was tried at one of its stations', () => {
    const learner = knows(learnerOf(railway), { '3-2': [20, 1] })
    expect(learnedPath(learner)).toEqual({ states: null, reason: 'unknown', walked: [3, 2] })
  })

  test('with values below 0 too, once all its roads were tried', () => {
    const known = { '3-2': [-1, 1], '3-4': [-3, 1], '3-5': [-2, 3], '2-1': [25, 1] } as const
    expect(learnedPath(knows(learnerOf(railway), known))).toMatchObject({ states: [3, 2, 1] })
  })

  test('of two equally good ways: the first of them', () => {
    const moves = [[1, 2], [3], [3], []].map((list) => list.map((to) => ({ to })))
    const known = { '0-1': [40, 9], '0-2': [40, 9], '1-3': [50, 9], '2-3': [50, 9] } as const
    const learner = knows(learnerOf({ map: { actions: moves }, start: 0, goal: 3 }), known)
    expect(learnedPath(learner)).toEqual({ states: [0, 1, 3], reason: 'found' })
  })

  test('without a value where only one road is open', () => {
    const moves = [[1], [2], []].map((list) => list.map((to) => ({ to })))
    const known = { '0-1': [0, 1], '1-2': [25, 1] } as const
    const learner = knows(learnerOf({ map: { actions: moves }, start: 0, goal: 2 }), known)
    expect(learnedPath(learner)).toMatchObject({ states: [0, 1, 2] })
  })
})

test('on the cliff, where every move costs, the way along its edge is learned', () => {
  const { map, start, goal } = gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], {
    cliffReward: -99,
  })
  const learner = learnerOf({ map, start, goal, goalReward: 0, stepCost: 1 }, { gamma: 1, rho: 0.1, nu: 0 })
  run(learner, 1e6, 20)
  expect(learnedPath(learner).states).toBeNull()
  run(learner, 1e6, 2000)
  // The shortest way is 13 moves: Sutton & Barto, example 6.6.
  expect(learnedPath(learner).states).toHaveLength(14)
})

test('after one try nothing is learned on the Railway, whatever the dice: only the last move can be worth something', () => {
  for (let seed = 1; seed <= 200; seed++) {
    const course = new Course(layOutWorld(railway), { ...usual, nu: 0 }, seed, { episodes: 1, steps: 1e4 })
    course.advance(1e4)
    expect(course.way().states).toBeNull()
    expect(course.foundIn()).toBeNull()
    expect(course.episodes.map(({ best }) => best)).toEqual([null])
  }
})

test('on any map a learned way is the best way, and does not hang on how its stations are numbered', () => {
  fc.assert(
    fc.property(randomTask, fc.nat(400), (task, moves) => {
      const learner = learnerOf(task)
      run(learner, moves)
      const learned = learnedPath(learner)
      if (!learned.states) return
      expect(learned).toEqual(greedyPath(learner))
      const { q } = learner
      const { first, meant, goal } = learner.world
      for (const [index, state] of learned.states.entries()) {
        if (state === goal || first[state + 1]! - first[state]! < 2) continue
        const own = [...q.slice(first[state], first[state + 1])]
        const taken = [...meant.slice(first[state], first[state + 1])].indexOf(learned.states[index + 1]!)
        expect(own[taken]).toBe(Math.max(...own))
        expect(own[taken]).not.toBe(0)
      }
    }),
  )
})
