import { resolve } from 'node:path'
import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer, type RunningServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import { median, ms, percentile, type Table } from './bench.ts'

const rounds = 11

/** Milliseconds until the blocks of a lab stand: with an empty cache, and once more in the same browser. */
async function starts(browser: Browser, { url }: RunningServer): Promise<readonly [number, number]> {
  const context = await browser.newContext({ baseURL: url, serviceWorkers: 'block' })
  const once = async () => {
    const page = await context.newPage()
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
  ].map((one) => ({ ...one, cold: [] as number[], warm: [] as number[] }))
  const browser = await launchBrowser()
  for (let round = 0; round < rounds; round++)
    for (const { server, cold, warm } of servers) {
      const [first, again] = await starts(browser, server)
      cold.push(first)
      warm.push(again)
    }
  await browser.close()
  await Promise.all(servers.map(({ server }) => server.close()))
  const row = (name: string, cold: readonly number[], warm: readonly number[]) => [
    name,
    ...[cold, warm].flatMap((times) => [ms(median(times)), ms(percentile(times, 0.9))]),
  ]
  const [first, last] = [servers[0]!, servers.at(-1)!]
  const ratio = (times: 'cold' | 'warm') => (median(last[times]) / median(first[times])).toFixed(2)
  return {
    title: 'A lab starts',
    how: `/lab/friendship over localhost until its blocks stand, ${rounds} times each, in turn; cold: an empty cache; warm: once more in the same browser.`,
    columns: ['checkout', 'cold, median', 'cold, p90', 'warm, median', 'warm, p90'],
    rows: [
      ...servers.map(({ name, cold, warm }) => row(name, cold, warm)),
      ...(beside ? [['this in terms of the other', ratio('cold'), '', ratio('warm'), '']] : []),
    ],
  }
}
