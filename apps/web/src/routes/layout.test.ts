import { expect, test } from 'vitest'
import { load } from './+layout.ts'

test('a page that a study may close is looked at on every way there, also if no study was on at first', async () => {
  // SvelteKit runs this again for the next page only if the route was read.
  let isRead = false
  const route = {
    get id() {
      isRead = true
      return '/' as const
    },
  }
  await load({ route } as unknown as Parameters<typeof load>[0])
  expect(isRead).toBe(true)
})
