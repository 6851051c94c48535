import type { World } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { content } from '../files.ts'
import { floorsIn } from './floors.ts'
import { folderAt } from './folder.ts'

const worldOf = (colour: string): World => ({
  ...{ size: { width: 20, height: 20 }, floor: { colour } },
  ...{ areas: [], lines: [], obstacles: [], robots: [] },
})

test('the four floors that were used last are painted once', () => {
  const floorOf = floorsIn(folderAt(content.path()))
  const [a, b, c, d, e] = ['#000001', '#000002', '#000003', '#000004', '#000005'].map(worldOf)
  const [first, second] = [floorOf(a!), floorOf(b!)]
  for (const world of [c!, d!]) floorOf(world)
  expect(floorOf(a!)).toBe(first)
  // The fifth floor replaces the one that was not used for the longest time.
  floorOf(e!)
  expect(floorOf(a!)).toBe(first)
  const again = floorOf(b!)
  expect(again).not.toBe(second)
  expect(again).toEqual(second)
})
