import { gridMap, layOutWorld } from '@botgarten/learning/q-learning'
import { expect, test } from 'vitest'
import { endsOf } from './rooms.ts'

test('where ice may lead, and what that brings: equal ends are one', () => {
  const world = layOutWorld(gridMap(['SF', 'FG'], { surefooted: 1 / 3 }))
  const q = Float64Array.from(world.names, () => 10)
  const from = (name: string) => endsOf(world, q, world.names.indexOf(name), 0.8)
  // From the corner, left and up lead nowhere.
  expect(from('0-left')).toEqual([
    { to: 0, odds: expect.closeTo(2 / 3, 12) as number, brings: 8 },
    { to: 2, odds: expect.closeTo(1 / 3, 12) as number, brings: 8 },
  ])
  // Beside the goal, whose reward is 50: behind it there is nothing more.
  expect(from('1-down').map(({ to, brings }) => [to, brings])).toEqual([
    [0, 8],
    [3, 50],
    [1, 8],
  ])
})
