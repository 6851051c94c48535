import { content } from '@botgarten/content/files'
import { layOutWorld, shortestPath, type QWorld } from '@botgarten/learning/q-learning'
import { describe, expect, test } from 'vitest'
import gymnasium from '../learning/q-learning/reference/worlds.json' with { type: 'json' }
import others from '../learning/q-learning/reference/grids.json' with { type: 'json' }
import { valueIteration } from '../learning/q-learning/testing/textbook.ts'
import { courseOf, drawWay, liesOn, wayFault, type MapFile } from './index.ts'

type Outcome = readonly [odds: number, to: number, reward: number, ends: boolean]
interface Reference {
  readonly gamma: number
  readonly table: { readonly [state: string]: { readonly [action: string]: readonly Outcome[] } }
  readonly q: { readonly [state: string]: readonly number[] }
}

const mapOf = (id: string): MapFile => content.mapFile(id)!

function worldOf(id: string): QWorld {
  const { map, start, goal, goalReward, stepCost } = mapOf(id)
  return layOutWorld({
    ...{ map, start: start!, goal: goal! },
    ...(goalReward !== undefined && { goalReward }),
    ...(stepCost !== undefined && { stepCost }),
  })
}

/** Equal outcomes as one, by where they lead, for what, and whether that is the end. */
function oddsOf(outcomes: readonly Outcome[]): ReadonlyMap<string, number> {
  const odds = new Map<string, number>()
  for (const [part, to, reward, ends] of outcomes) {
    const key = `${to} ${reward} ${ends}`
    if (part > 0) odds.set(key, (odds.get(key) ?? 0) + part)
  }
  return odds
}

const outcomesOf = (world: QWorld, action: number): Outcome[] =>
  Array.from({ length: world.outcome[action + 1]! - world.outcome[action]! }, (_, k) => {
    const end = world.outcome[action]! + k
    const before = k === 0 ? 0 : world.upTo[end - 1]!
    return [
      world.upTo[end]! - before,
      world.to[end]!,
      world.reward[end]!,
      world.terminal[world.to[end]!] === 1,
    ]
  })

/** `order`: which action of the reference each of ours is. */
const worlds = [
  { id: 'lake', by: 'Gymnasium', reference: gymnasium.lake4, order: [0, 1, 2, 3] },
  { id: 'lake-8', by: 'Gymnasium', reference: gymnasium.lake8, order: [0, 1, 2, 3] },
  { id: 'cliff', by: 'Gymnasium', reference: gymnasium.cliff, order: [3, 2, 1, 0] },
  { id: 'windy', by: 'Sutton & Barto', reference: others.windy, order: [0, 1, 2, 3] },
  { id: 'errand', by: 'a table of its own', reference: others.errand, order: [0, 1, 2, 3] },
  { id: 'bandit', by: 'Sutton & Barto', reference: others.bandit, order: [0, 1] },
]

describe.each(worlds)('the grid $id', ({ id, by, reference, order }) => {
  const world = worldOf(id)
  const { table, q, gamma } = reference as unknown as Reference
  const states = Array.from({ length: world.states }, (_, state) => state)
  const actions = (state: number) => order.slice(0, world.first[state + 1]! - world.first[state]!)

  test(`leads where ${by} leads, as likely and for the same reward`, () => {
    for (const state of states)
      actions(state).forEach((theirs, index) => {
        const ours = oddsOf(outcomesOf(world, world.first[state]! + index))
        const given = oddsOf(table[state]![theirs]!)
        expect([...ours.keys()].toSorted()).toEqual([...given.keys()].toSorted())
        for (const [key, odds] of given) expect(Math.abs(ours.get(key)! - odds)).toBeLessThan(1e-9)
      })
  })

  test('is worth the same by value iteration', () => {
    const theirs = states.flatMap((state) => actions(state).map((action) => q[state]![action]!))
    const ours = valueIteration(world, gamma)
    expect(ours).toHaveLength(theirs.length)
    theirs.forEach((value, index) => expect(Math.abs(value - ours[index]!)).toBeLessThan(1e-9))
  })
})

test('the best way through the windy rooms has 15 moves (Sutton & Barto, example 6.5)', () => {
  expect(others.windy.steps).toBe(15)
  expect(shortestPath(worldOf('windy'))! - 1).toBe(15)
})

const settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 } as const

test.each(['cliff', 'windy', 'errand'])(
  'a way learned in the rooms of %s is a floor with coloured doors that can be driven',
  (id) => {
    const map = mapOf(id)
    const outline = {
      ...{ blocks: { map: 'map' }, map: id, start: map.start!, goal: map.goal!, closed: [], settings },
      ...{ episodes: 20_000, moves: 400_000 },
    }
    const course = courseOf(outline, map, 1)
    course.advance(outline.moves)
    const { states } = course.way()
    expect(states).not.toBeNull()
    expect(wayFault(map, states!)).toBeNull()
    const { scene } = drawWay(map, states!)
    const doors = scene.areas.filter((area) => area.id.startsWith('door-'))
    expect(new Set(doors.map(({ colour }) => colour))).toEqual(new Set(['#0090C0', '#F7D117']))
    expect(liesOn(map, scene)).toBe(true)
  },
)
