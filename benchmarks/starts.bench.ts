import { resolve } from 'node:path'
import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer, type RunningServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import { median, ms, percentile, type Table } from './bench.ts'

const rounds = Number(process.env['BOTGARTEN_ROUNDS'] ?? 11)

/** What a child's device and line are like: `slow` divides the processor's speed, `wait` in milliseconds, `line` in bytes a second. */
const places = [
  { name: 'at full speed, loopback', slow: 1 },
  { name: 'at full speed, 40 ms and 10 Mbit/s', slow: 1, wait: 40, line: 10e6 / 8 },
  { name: '4 × slower, 40 ms and 10 Mbit/s', slow: 4, wait: 40, line: 10e6 / 8 },
]

type Place = (typeof places)[number]

/** Makes a page's processor and line as slow as in this place. */
async function move(page: Page, { slow, wait, line }: Place): Promise<void> {
  const session = await page.context().newCDPSession(page)
  await session.send('Emulation.setCPUThrottlingRate', { rate: slow })
  if (wait === undefined) return
  await session.send('Network.enable')
  const speed = { downloadThroughput: line, uploadThroughput: line }
  await session.send('Network.emulateNetworkConditions', { offline: false, latency: wait, ...speed })
}

/** Milliseconds until the blocks of a lab stand: with an empty cache, and once more in the same browser. */
async function starts(
  browser: Browser,
  { url }: RunningServer,
  place: Place,
): Promise<readonly [number, number]> {
  const context = await browser.newContext({ baseURL: url, serviceWorkers: 'block' })
  const once = async () => {
    const page = await context.newPage()
    await move(page, place)
    const before = performance.now()
    await page.goto('/lab/friendship')
    await page.locator('.blocklySvg .blocklyBlockCanvas .blocklyDraggable').first().waitFor()
    const took = performance.now() - before
    await page.close()
    return took
  }
  const took = [await once(), await once()] as const
  await context.close()
  return took
}

/** How long a lab takes to stand; beside another checkout, built, whose folder BOTGARTEN_BESIDE names. */
export default async function startsOfLab(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const servers = [
    ...(beside ? [{ name: 'the other', server: await serverOf(resolve(beside)) }] : []),
    { name: 'this', server: await startServer({ port: 0, host: '127.0.0.1' }) },
  ]
  const browser = await launchBrowser()
  const rows = []
  for (const place of places) {
    const taken = servers.map(({ name, server }) => ({
      name,
      server,
      cold: [] as number[],
      warm: [] as number[],
    }))
    for (let round = 0; round < rounds; round++)
      for (const { server, cold, warm } of taken) {
        const [first, again] = await starts(browser, server, place)
        cold.push(first)
        warm.push(again)
      }
    rows.push(...taken.map(({ name, cold, warm }) => row(place, name, cold, warm)))
    const [first, last] = [taken[0]!, taken.at(-1)!]
    const ratio = (times: 'cold' | 'warm') => (median(last[times]) / median(first[times])).toFixed(2)
    if (beside) rows.push([place.name, 'this in terms of the other', ratio('cold'), '', ratio('warm'), ''])
  }
  await browser.close()
  await Promise.all(servers.map(({ server }) => server.close()))
  return {
    title: 'A lab starts',
    how: `/lab/friendship until its blocks stand, ${rounds} times each, in turn; cold: an empty cache; warm: once more in the same browser.`,
    columns: ['where', 'checkout', 'cold, median', 'cold, p90', 'warm, median', 'warm, p90'],
    rows,
  }
}

const row = (place: Place, name: string, cold: readonly number[], warm: readonly number[]) => [
  place.name,
  name,
  ...[cold, warm].flatMap((times) => [ms(median(times)), ms(percentile(times, 0.9))]),
]
