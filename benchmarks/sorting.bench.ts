import { resolve } from 'node:path'
import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { SortingHands } from '../e2e/child-sorting.ts'
import { Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import type { Table } from './bench.ts'
import {
  frameCells,
  frameColumns,
  frameNotes,
  freshPage,
  rounds,
  throttle,
  throttled,
  watchFrames,
  type Watched,
} from './slow.ts'

const count = 2000
const seconds = 6

/** Points all over the plane: flags move for many rounds. */
function table(): string {
  const rows = Array.from({ length: count }, (_, row) => `${(row * 7919) % 1000};${(row * 104_729) % 997}`)
  return `x;y\n${rows.join('\n')}\n`
}

/** On a slow laptop: at rest and while it plays. */
async function watch(browser: Browser, baseURL: string): Promise<readonly Watched[]> {
  const page = await freshPage(browser, baseURL)
  const sorting = new SortingHands(new Child(page, 'en'))
  await sorting.opens('points')
  await sorting.opensTable(table())
  await sorting.seesPoints(count)
  for (let press = 0; press < 2; press += 1) await sorting.presses('moreFlags')
  await throttled(page)
  await page.waitForTimeout(1000)
  const rest = await watchFrames(page, seconds)
  await sorting.presses('play')
  const play = await watchFrames(page, seconds)
  await page.context().close()
  return [rest, play]
}

/** How the sorting playground feels on a slow laptop; beside another checkout, built, whose folder BOTGARTEN_BESIDE names. */
export default async function sorting(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const places = [
    ...(beside ? [{ name: 'the other', server: await serverOf(resolve(beside)) }] : []),
    { name: 'this', server: await startServer({ port: 0, host: '127.0.0.1' }) },
  ].map((place) => ({ ...place, runs: [] as (readonly Watched[])[] }))
  const browser = await launchBrowser()
  for (let round = 0; round < rounds; round += 1)
    for (const { server, runs } of places) runs.push(await watch(browser, server.url))
  await browser.close()
  await Promise.all(places.map(({ server }) => server.close()))
  return {
    title: 'The sorting playground on a slow laptop',
    how: `Chromium, 1366 × 768, density 1, ${throttle} × CPU throttle; ${count} points, 5 flags, watched for ${seconds} seconds at rest, then played at 1 ×, ${rounds} times each, in turn: medians, least and most. Goal: 95th percentile ≤ 18 ms.`,
    columns: ['what', ...frameColumns],
    rows: places.flatMap(({ name, runs }) =>
      ['at rest', 'played'].map((act, index) => [
        `${name}, ${count} points ${act}`,
        ...frameCells(runs.map((run) => run[index]!)),
      ]),
    ),
    notes: frameNotes,
  }
}
