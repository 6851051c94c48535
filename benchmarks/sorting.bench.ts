import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { SortingHands } from '../e2e/child-sorting.ts'
import { Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { ms, percentile, type Table } from './bench.ts'
import { noteFrames } from './in-page.ts'
import { freshPage, takeGaps, throttled } from './slow.ts'

const count = 2000

/** Points all over the plane: flags move for many rounds. */
function table(): string {
  const rows = Array.from({ length: count }, (_, row) => `${(row * 7919) % 1000};${(row * 104_729) % 997}`)
  return `x;y\n${rows.join('\n')}\n`
}

/** Ten seconds on a slow laptop: gaps between frames, at rest and while it plays. */
async function gapsOn(browser: Browser, baseURL: string): Promise<{ rest: number[]; play: number[] }> {
  const page = await freshPage(browser, baseURL)
  const sorting = new SortingHands(new Child(page, 'en'))
  await sorting.opens('points')
  await sorting.opensTable(table())
  await sorting.seesPoints(count)
  for (let press = 0; press < 2; press += 1) await sorting.presses('moreFlags')
  await throttled(page)
  await page.waitForTimeout(1000)
  await page.evaluate(noteFrames)
  const frames = async () => {
    await page.waitForTimeout(10_000)
    return takeGaps(page)
  }
  const rest = await frames()
  await sorting.presses('play')
  const play = await frames()
  await page.context().close()
  return { rest, play }
}

/** How the sorting playground feels on a slow laptop. */
export default async function sorting(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const { rest, play } = await gapsOn(browser, server.url)
  await browser.close()
  await server.close()
  return {
    title: 'The sorting playground on a slow laptop',
    how: `Chromium without a graphics card, 1366 × 768, processor at a quarter; ${count} points, 5 flags, played for ten seconds at 1 ×.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      ['frame, median', ms(percentile(play, 0.5)), ''],
      ['frame, p95', ms(percentile(play, 0.95)), '≤ 18 ms'],
      ['frame, p95, at rest before', ms(percentile(rest, 0.95)), ''],
      ['frame, longest', ms(Math.max(...play)), ''],
    ],
  }
}
