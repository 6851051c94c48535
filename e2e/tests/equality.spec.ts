// Rooms: simulation
import { isLong } from '@botgarten/numbers/testing'
import { expect, test } from '@playwright/test'
import { outcomesIn } from '../runs/in-browser.ts'
import { names, outcomes } from '../runs/runs.ts'

/** Four of them go through all behaviours but one, and through all worlds. */
const some = names.filter((_, at) => isLong || at % 5 === 0)

test(`rules 7 and 8: ${some.length} programs of a minute each, pushing included, are equal in Node and Chromium, also from the middle on`, async ({
  page,
}) => {
  expect(names).toHaveLength(20)
  const here = outcomes(some)
  expect(here.map(({ name }) => name)).toEqual(some)
  expect(await outcomesIn(page, some)).toEqual(here)
  expect(new Set(here.map(({ hash }) => hash)).size, 'each program goes its own way').toBe(some.length)
  const pushing = here.filter(({ pushed }) => pushed).length
  expect(pushing, 'most of them push something').toBeGreaterThan(some.length * 0.7)
  expect(here.filter(({ problem }) => problem !== null)).toEqual([])
  // The second half of each minute, from the nearest keyframe on.
  for (const { name, hash, restored } of here) expect(restored, name).toBe(hash)
})
