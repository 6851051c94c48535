import { stream } from '@botgarten/numbers'
import { isLong, sample } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  greedyPath,
  createLearner,
  gridMap,
  layOutWorld,
  run,
  type QWorld,
  type Settings,
  type Task,
} from './index.ts'
import { breadthFirst, randomTask, valueIteration } from './testing/textbook.ts'
import worlds from './reference/worlds.json' with { type: 'json' }

const exact: Settings = {
  ...{ rules: 'standard', algorithm: 'q', alpha: 1, gamma: 0.5, nu: 0.5, rho: 1 },
  alphaDecay: { kind: 'visits' },
}

function learn(task: Task, settings: Settings, moves: number, seed = 1) {
  const learner = createLearner(layOutWorld(task), settings, stream(seed, 'learn/test/1'))
  run(learner, moves)
  return learner
}

/** Values by move; 0 where an episode has ended, since no move is made there. */
const optimal = (world: QWorld, gamma: number) =>
  valueIteration(world, gamma).map((value, move) => (world.terminal[world.from[move]!] === 1 ? 0 : value))

const farthest = (a: ArrayLike<number>, b: readonly number[]) =>
  b.reduce((most, value, index) => Math.max(most, Math.abs(value - a[index]!)), 0)

describe('Q with α = 10/(9 + n) and full exploration', () => {
  test('equals value iteration on random graphs, and its greedy way is a shortest one', () => {
    for (const task of fc.sample(randomTask, { numRuns: isLong ? 200 : 20, seed: 2026 })) {
      const learner = learn(task, exact, 60_000)
      expect(farthest(learner.q, optimal(learner.world, exact.gamma))).toBeLessThan(1e-9)
      const shortest = breadthFirst(layOutWorld(task))
      expect(greedyPath(learner).states?.length ?? null).toBe(shortest)
    }
  })

  test('equals value iteration on the cliff, and walks along its edge', () => {
    const { map, start, goal } = cliff()
    const task = { map, start, goal, goalReward: 0, stepCost: 1 }
    const learner = learn(task, exact, 2_000_000)
    expect(farthest(learner.q, optimal(learner.world, exact.gamma))).toBeLessThan(1e-9)
    expect(greedyPath(learner).states).toEqual([36, ...Array.from({ length: 12 }, (_, x) => 24 + x), 47])
  })
})

const cliff = () =>
  gridMap(['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'], { cliffReward: -99 })
const lake4 = () => gridMap(['SFFF', 'FHFH', 'FFFH', 'HFFG'], { surefooted: 1 / 3 })
const lake8 = () =>
  gridMap(['SFFFFFFF', 'FFFFFFFF', 'FFFHFFFF', 'FFFFFHFF', 'FFFHFFFF', 'FHHFFFHF', 'FHFFHFHF', 'FFFHFFFG'], {
    surefooted: 1 / 3,
  })

describe.each([
  { name: 'lake4', grid: lake4, pay: { goalReward: 1 }, order: [0, 1, 2, 3] },
  { name: 'lake8', grid: lake8, pay: { goalReward: 1 }, order: [0, 1, 2, 3] },
  // Its actions are up, right, down, left.
  { name: 'cliff', grid: cliff, pay: { goalReward: 0, stepCost: 1 }, order: [3, 2, 1, 0] },
] as const)("Gymnasium's $name", ({ name, grid, pay, order }) => {
  const { map, start, goal } = grid()
  const world = layOutWorld({ map, start, goal, ...pay })
  const { table, q, gamma } = worlds[name]
  const rows = Object.entries(table as unknown as Table)

  test('leads from every station by every move to the same ones, as likely and for the same reward', () => {
    let compared = 0
    for (const [state, actions] of rows) {
      const first = world.first[Number(state)]!
      if (world.first[Number(state) + 1] === first) continue
      for (const [action, outcomes] of Object.entries(actions)) {
        const ours = oddsOf(outcomesAt(first + order[Number(action)]!))
        const theirs = oddsOf(outcomes)
        expect([...ours.keys()].toSorted()).toEqual([...theirs.keys()].toSorted())
        for (const [key, odds] of theirs) expect(Math.abs(ours.get(key)! - odds)).toBeLessThan(1e-9)
        compared += 1
      }
    }
    expect(compared).toBe(world.meant.length)
  })

  test('is worth the same', () => {
    const theirs = rows.flatMap(([state]) =>
      world.first[Number(state)] === world.first[Number(state) + 1]
        ? []
        : order.map((action) => q[Number(state)]![action]!),
    )
    expect(farthest(valueIteration(world, gamma), theirs)).toBeLessThan(1e-9)
  })

  function outcomesAt(move: number): Outcome[] {
    const ends = Array.from(
      { length: world.outcome[move + 1]! - world.outcome[move]! },
      (_, index) => world.outcome[move]! + index,
    )
    return ends.map((end) => {
      const odds = world.upTo[end]! - (end === world.outcome[move] ? 0 : world.upTo[end - 1]!)
      return [odds, world.to[end]!, world.reward[end]!, world.terminal[world.to[end]!] === 1]
    })
  }
})

type Outcome = [odds: number, to: number, reward: number, done: boolean]
type Table = Record<string, Record<string, Outcome[]>>

/** What may happen, by what it is; thirds of the same are added up. */
function oddsOf(outcomes: readonly Outcome[]): Map<string, number> {
  const all = new Map<string, number>()
  for (const [odds, ...what] of outcomes) all.set(what.join(' '), (all.get(what.join(' ')) ?? 0) + odds)
  return all
}

test.each(sample([{ seed: 1 }, { seed: 2 }, { seed: 3 }], 1))(
  'sampled Q on the slippery lake comes within a fiftieth of the largest value, seed $seed',
  ({ seed }) => {
    const { map, start, goal } = lake4()
    const settings = { ...exact, gamma: 0.95, nu: 0.5 }
    const learner = learn({ map, start, goal, goalReward: 1 }, settings, 10_000_000, seed)
    const wanted = valueIteration(learner.world, settings.gamma)
    expect(farthest(learner.q, wanted)).toBeLessThan(0.02 * Math.max(...wanted))
  },
)
