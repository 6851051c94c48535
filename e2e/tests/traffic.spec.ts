// Rooms: app
import { expect, test } from '../house.ts'
import { trafficOf } from '../traffic.ts'

test.use({ serviceWorkers: 'allow' })

// What is fetched for times without a network comes after the page stands, through the service worker, and is counted apart:
// offline.spec.ts.
test('the whole lab comes in at most 40 requests and 0.8 MB', async ({ page, child }) => {
  const { requests, bytes } = await trafficOf(page, '/lab/friendship', () => child.seesBlocks())
  expect(requests).toBeGreaterThan(1)
  expect(requests).toBeLessThanOrEqual(40)
  expect(bytes).toBeGreaterThan(10_000)
  expect(bytes).toBeLessThanOrEqual(800_000)
})
