import { resolve } from 'node:path'
import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import { median, type Table } from './bench.ts'
import { freshChild, heapOf } from './slow.ts'

const rounds = Number(process.env['BOTGARTEN_ROUNDS'] ?? 5)

/** Bytes in use when the blocks of a lab stand: as they are then, and after collection. */
async function heaps(browser: Browser, url: string): Promise<readonly [loaded: number, collected: number]> {
  const { page } = await freshChild(browser, url)
  await page.goto('/lab/friendship')
  await page.locator('.blocklySvg .blocklyBlockCanvas .blocklyDraggable').first().waitFor()
  const session = await page.context().newCDPSession(page)
  const { usedSize } = await session.send('Runtime.getHeapUsage')
  const collected = await heapOf(page)
  await page.context().close()
  return [usedSize, collected]
}

const spread = (values: readonly number[]) => {
  const [middle, least, most] = [median(values), Math.min(...values), Math.max(...values)].map((bytes) =>
    (bytes / 1e6).toFixed(1),
  )
  return `${middle} MB (${least} to ${most})`
}

/** What an open lab holds; beside another checkout, built, whose folder BOTGARTEN_BESIDE names. */
export default async function memory(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const places = [
    ...(beside ? [{ name: 'the other', server: await serverOf(resolve(beside)) }] : []),
    { name: 'this', server: await startServer({ port: 0, host: '127.0.0.1' }) },
  ].map((place) => ({ ...place, loaded: [] as number[], collected: [] as number[] }))
  const browser = await launchBrowser()
  for (let round = 0; round < rounds; round += 1)
    for (const { server, loaded, collected } of places) {
      const [before, after] = await heaps(browser, server.url)
      loaded.push(before)
      collected.push(after)
    }
  await browser.close()
  await Promise.all(places.map(({ server }) => server.close()))
  return {
    title: 'What an open lab holds',
    how: `Heap of /lab/friendship as soon as its blocks stand, ${rounds} times each in a fresh profile, in turn: medians, least and most. Goals: ≤ 30 MB without a forced collection, ≤ 12 MB after one.`,
    columns: ['checkout', 'right after load', 'after collection'],
    rows: places.map(({ name, loaded, collected }) => [name, spread(loaded), spread(collected)]),
  }
}
