import { expect, test } from '@playwright/test'
import { outcomesIn } from '../runs/in-browser.ts'
import { outcomes } from '../runs/runs.ts'

test('rule 7: twenty programs of a minute each, pushing included, are equal in Node and Chromium', async ({
  page,
}) => {
  const here = outcomes()
  expect(here).toHaveLength(20)
  expect(await outcomesIn(page)).toEqual(here)
  expect(new Set(here.map(({ hash }) => hash)).size, 'each program goes its own way').toBe(20)
  expect(here.filter(({ pushed }) => pushed).length, 'most of them push something').toBeGreaterThan(15)
  expect(here.filter(({ problem }) => problem !== null)).toEqual([])
})

test('rule 8: the second half of each minute, from the nearest keyframe on, is the same to the last bit', () => {
  for (const { name, hash, restored } of outcomes()) expect(restored, name).toBe(hash)
})
