import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { leftEye, leftWheel, rightWheel } from '../e2e/child.ts'
import { TimeHands } from '../e2e/child-time.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, percentile, type Table } from './bench.ts'
import { freshChild, throttle, throttled, untilKept, watchFrames } from './slow.ts'

/** So many robots circle on Friendship's floor, each with a network of weights of its own, and all panes are live. */
async function driving(browser: Browser, url: string, robots: number) {
  const child = await freshChild(browser, url)
  const hands = new TimeHands(child)
  await child.opensLab('friendship')
  for (let robot = 1; robot <= robots; robot += 1) {
    if (robot > 1) await hands.adds('shared')
    await child.typesWeight(leftEye, leftWheel, 0.6)
    await child.typesWeight(leftEye, rightWheel, (20 + 5 * robot) / 100)
  }
  await throttled(child.page)
  await untilKept(child.page)
  await child.pressesStart()
  await child.page.waitForTimeout(2000)
  const frames = await watchFrames(child.page, 10)
  await child.page.context().close()
  return frames
}

/** Several robots with networks in one world on a slow laptop. */
export default async function robots(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const rows = []
  for (const count of [1, 2, 4]) {
    const { gaps, longest, perFrame } = await driving(browser, server.url, count)
    const goal = count === 4 ? '≤ 18 ms' : ''
    rows.push([
      ...[count, ms(percentile(gaps, 0.95)), goal, ms(median(gaps))],
      ...[ms(perFrame), ms(longest)],
    ])
  }
  await browser.close()
  await server.close()
  return {
    title: 'Several robots on a slow laptop',
    how: `Chromium at ${throttle} × CPU throttle, 1366 × 768, all panes live: robots with networks and weights of their own circle on the floor of Friendship for ten seconds, once the lab is kept for times without a network.`,
    columns: [
      'robots',
      'distance between frames, 95th percentile',
      'goal',
      'median',
      'main thread a frame, mean of a trace',
      'longest task',
    ],
    rows,
    notes: ['Headless, drawn by the processor: no graphics card helps.'],
  }
}
