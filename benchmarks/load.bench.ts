import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Child } from '../e2e/child.ts'
import { trafficOf } from '../e2e/traffic.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import type { Table } from './bench.ts'

const pages = [
  { path: '/', stands: (child: Child) => child.seesTitle() },
  { path: '/lab/friendship', stands: (child: Child) => child.seesBlocks() },
  { path: '/lab/free', stands: (child: Child) => child.seesBlocks() },
]

/** Milliseconds until the lab stands when it is loaded once more over localhost and nobody answers. */
async function withoutServer(browser: Browser): Promise<number> {
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const page = await browser.newPage({ baseURL: server.url })
  const child = new Child(page, 'en')
  await child.opensLab('friendship')
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated')
  await server.close()
  const before = performance.now()
  await child.reloads()
  const took = performance.now() - before
  await child.pressesStart()
  await page.close()
  return took
}

/** What a page costs on the wire when it is opened for the first time. */
export default async function load(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const rows = []
  for (const { path, stands } of pages) {
    const page = await browser.newPage({ baseURL: server.url })
    const { requests, bytes } = await trafficOf(page, path, () => stands(new Child(page, 'en')))
    await page.close()
    rows.push([path, requests, `${(bytes / 1000).toFixed(0)} kB`])
  }
  const alone = await withoutServer(browser)
  await browser.close()
  await server.close()
  return {
    title: 'First load of a page',
    how: 'Chromium with an empty cache, until nothing more is asked for; bytes on the wire with brotli, headers included.',
    columns: ['page', 'requests', 'transfer'],
    rows,
    notes: [
      'Goal for the lab: at most 40 requests and 800 kB.',
      `Second load of /lab/friendship over localhost with the server stopped: works, its blocks stand after ${alone.toFixed(0)} ms.`,
    ],
  }
}
