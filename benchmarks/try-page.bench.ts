import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { TryHands } from '../e2e/child-trying.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import type { Table } from './bench.ts'
import {
  frameCells,
  frameColumns,
  frameNotes,
  freshChild,
  rounds,
  throttle,
  throttled,
  untilKept,
  watchFrames,
} from './slow.ts'

const seconds = 5
const speeds = ['1', '4', '16'] as const

/** The robot tries with all panes live: the table fills, the fan and the coin go along. */
async function trying(browser: Browser, url: string, speed: (typeof speeds)[number]) {
  const child = await freshChild(browser, url)
  const bo = new TryHands(child)
  await bo.opensSolution()
  await untilKept(child.page)
  await throttled(child.page)
  await child.pressesStart()
  await bo.time.opens()
  await bo.time.chooses(speed)
  await child.page.waitForTimeout(3000)
  const watched = await watchFrames(child.page, seconds)
  await child.page.context().close()
  return watched
}

/** How smoothly a slow laptop shows a robot that learns by trying with its own sensors. */
export default async function tryPage(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  try {
    const watched = speeds.map((speed) => ({ speed, all: [] as Awaited<ReturnType<typeof trying>>[] }))
    for (let round = 0; round < rounds; round += 1)
      for (const { speed, all } of watched) all.push(await trying(browser, server.url, speed))
    return {
      title: 'Learning by trying with the robot’s own sensors, on the screen',
      how: `Card NN 24 with its solution's blocks, from nothing learned; 1366 × 768, processor at a ${throttle}th. ${rounds} rounds of ${seconds} s each, in turn.`,
      columns: ['speed', ...frameColumns],
      rows: watched.map(({ speed, all }) => [`× ${speed}`, ...frameCells(all)]),
      notes: frameNotes,
    }
  } finally {
    await browser.close()
    await server.close()
  }
}
