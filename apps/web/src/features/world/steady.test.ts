import type { View } from '@botgarten/lab'
import type { Obstacle, World } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { standing } from './steady.ts'

const thing = (id: string): Obstacle => ({
  id,
  shape: { kind: 'circle', radius: 5 },
  pose: { x: 0, y: 0, heading: 0 },
  fixed: false,
  colour: '#0057A6',
})
const world = { obstacles: [thing('a'), thing('b')] } as unknown as World
const view = (...xs: number[]) =>
  ({ obstacles: xs.map((x, i) => ({ id: 'ab'[i], pose: { x, y: 0, heading: 0 } })) }) as unknown as View

test('what stands still is the same object from frame to frame, so that nothing is drawn again', () => {
  const first = standing(view(1, 2), world, [])
  expect(standing(view(1, 2), world, first)).toBe(first)
  const second = standing(view(1, 3), world, first)
  expect(second[0]).toBe(first[0])
  expect(second[1]).toEqual({ id: 'b', pose: { x: 3, y: 0, heading: 0 }, thing: world.obstacles[1] })
})

test('an obstacle the world does not know yet is left out', () => {
  expect(standing(view(1, 2, 3), world, [])).toHaveLength(2)
})
