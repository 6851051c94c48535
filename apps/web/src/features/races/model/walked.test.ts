import { layOutWorld } from '@botgarten/learning/q-learning'
import { expect, test } from 'vitest'
import { resultOfWalk, type Tried } from './walked.ts'

const ring = layOutWorld({
  map: { actions: [[{ to: 1 }, { to: 3 }], [{ to: 2 }, { to: 0 }], [{ to: 1 }, { to: 3 }], []] },
  ...{ start: 0, goal: 3 },
})
const tried = (states: number[], atGoal = true): Tried => ({
  states,
  atGoal,
  stars: atGoal ? 50 : 0,
  falls: 1,
})

test('a child is a lane with one run: its moves add up, and its last way to the goal is what it has learned', () => {
  const { bill, curves, ways, runs } = resultOfWalk(
    [tried([0, 1, 2, 3]), tried([0, 3]), tried([0, 1], false)],
    ring,
  )
  expect(runs).toBe(1)
  expect(bill).toMatchObject({ tries: 3, moves: 5, stars: 100, falls: 3, first: 4, found: 1, reaches: null })
  expect(curves.pace.map(({ middle }) => middle)).toEqual([3, 1, 1])
  expect(ways.map(([way]) => way)).toEqual([
    { states: [0, 1, 2, 3], runs: 1 },
    { states: [0, 3], runs: 1 },
    { states: [0, 3], runs: 1 },
  ])
})

test('who never came to the goal has found no way', () => {
  const { bill, ways } = resultOfWalk([tried([0, 1, 0], false)], ring)
  expect(bill.first).toBeNull()
  expect(ways[0]![0]).toMatchObject({ reason: 'neverReached' })
})
