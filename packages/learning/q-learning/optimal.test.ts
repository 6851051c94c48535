import fc from 'fast-check'
import { expect, test } from 'vitest'
import { layOutWorld, optimumOf } from './index.ts'
import { randomTask, valueIteration } from './testing/textbook.ts'

const gamma = fc.constantFrom(0.2, 0.8, 0.95)

test('values of the best behaviour are those of the textbook, on any map', () => {
  fc.assert(
    fc.property(randomTask, gamma, (task, discount) => {
      const world = layOutWorld(task)
      const { q } = optimumOf(world, discount)
      valueIteration(world, discount).forEach((value, action) => expect(q[action]).toBeCloseTo(value, 9))
    }),
    { numRuns: 50 },
  )
})

test('the best actions of a state are all that are worth the most', () => {
  const both = { actions: [[{ to: 1 }, { to: 2 }], [{ to: 3 }], [{ to: 3 }], []] }
  const { best, q } = optimumOf(layOutWorld({ map: both, start: 0, goal: 3 }), 0.8)
  expect(best).toEqual([[0, 1], [2], [3], []])
  expect(q).toEqual([40, 40, 50, 50])
})

test('probabilities count', () => {
  const slippery = { actions: [[{ to: 1, slip: 0.5 }, { to: 2 }], [], []], terminals: [2] }
  const { q } = optimumOf(layOutWorld({ map: slippery, start: 0, goal: 1 }), 0.8)
  expect(q).toEqual([25, 0])
})
