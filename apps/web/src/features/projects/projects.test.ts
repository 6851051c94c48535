import type { Project } from '@botgarten/programs'
import { expect, test } from 'vitest'
import type { Listed } from '#storage/projects.ts'
import { findProjects, stripeOf } from './projects.ts'
import { cardConfig, type Obstacle, type World } from '@botgarten/simulation'
import fc from 'fast-check'

const kept = (name: string, changed: number): Listed => ({
  ...{ id: name, changed },
  project: { name } as Project,
})
const all = [kept('Möwe 10', 3), kept('möwe 9', 2), kept('Rallye', 1)]
const names = (words: string, order: 'time' | 'name' = 'time') =>
  findProjects(all, { words, order, locale: 'de' }, ({ project }) => project.name).map(({ id }) => id)

test('no words find everything, as it was kept', () =>
  expect(names('  ')).toEqual(['Möwe 10', 'möwe 9', 'Rallye']))

test('capitals and dots on letters do not matter', () => {
  expect(names('MOWE')).toEqual(['Möwe 10', 'möwe 9'])
  expect(names('möwe 1')).toEqual(['Möwe 10'])
  expect(names('zebra')).toEqual([])
})

test('by name, numbers are counted as numbers', () =>
  expect(names('', 'name')).toEqual(['möwe 9', 'Möwe 10', 'Rallye']))

const thing = (x: number, y: number): Obstacle => ({
  ...{ id: 'thing', shape: { kind: 'circle', radius: 5 }, fixed: true, colour: '#B30006' },
  pose: { x, y, heading: 0 },
})
const worldOf = (width: number, height: number, bo: { x: number; y: number }, ...obstacles: Obstacle[]) =>
  ({
    ...{ size: { width, height }, floor: { colour: '#FFFFFF' }, areas: [], lines: [], obstacles },
    robots: [{ id: 'bo', pose: { ...bo, heading: 0 }, program: 'main', brain: '', config: cardConfig }],
  }) satisfies World

test('a tile shows Bo, and what is next to it where both fit', () => {
  const { top, height } = stripeOf(worldOf(600, 400, { x: 440, y: 100 }, thing(300, 200), thing(20, 390)))
  expect(top).toBeLessThan(400 - 200 - 5)
  expect(top + height).toBeGreaterThan(400 - 100 + 20)
})

test('a low world is shown whole', () => {
  expect(stripeOf(worldOf(600, 200, { x: 10, y: 10 }))).toEqual({ top: 0, height: 200 })
})

test('wherever Bo and the things are, the stripe lies in the world and Bo in the stripe', () => {
  const size = fc.integer({ min: 50, max: 2000 })
  const share = fc.double({ min: 0, max: 1, noNaN: true })
  fc.assert(
    fc.property(size, size, share, share, fc.array(fc.tuple(share, share)), (width, height, x, y, things) => {
      const at = things.map(([right, up]) => thing(right * width, up * height))
      const stripe = stripeOf(worldOf(width, height, { x: x * width, y: y * height }, ...at))
      const bo = height - y * height
      expect(stripe.top).toBeGreaterThanOrEqual(0)
      expect(stripe.top + stripe.height).toBeLessThanOrEqual(height + 1e-9)
      expect(bo).toBeGreaterThanOrEqual(stripe.top - 1e-9)
      expect(bo).toBeLessThanOrEqual(stripe.top + stripe.height + 1e-9)
    }),
  )
})

test('of several things the nearest one counts; without a robot the middle of the world is seen', () => {
  // 260 × 200 cm: the stripe is 100 cm high, and the robot may be 10 cm off its middle.
  const near = thing(135, 130)
  const far = thing(70, 75)
  const seen = (...things: Obstacle[]) => stripeOf(worldOf(260, 200, { x: 130, y: 100 }, ...things)).top
  // The near one is above the robot: 200 − 100 − 10 − 50 = 40 cm from the top.
  expect([seen(far, near), seen(near, far), seen(far)]).toEqual([40, 40, 60])
  const world = worldOf(260, 200, { x: 130, y: 100 })
  expect(stripeOf({ ...world, robots: [] }).top).toBe(50)
})
