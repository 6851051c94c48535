import type { Browser, Page } from '@playwright/test'
import { addRoad, addStation, emptyMap, writeMap } from '@botgarten/maps/own'
import type { RoadMap } from '@botgarten/programs'
import { launchBrowser } from '../e2e/browser.ts'
import type { Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { ms, percentile, type Table } from './bench.ts'
import { frameNotes, freshChild, throttle, throttled, watchFrames } from './slow.ts'

/** The largest map there may be: 8 × 5 stations, each joined with those around it. */
function largest(): RoadMap {
  const places = Array.from({ length: 40 }, (_, index) => ({
    x: 100 + 200 * (index % 8),
    y: 120 + 190 * Math.floor(index / 8),
  }))
  const stations = places.reduce(addStation, emptyMap('40 stations'))
  const pairs = places.flatMap((_, from) =>
    [1, 8, 9, 7]
      .map((step) => from + step)
      .filter((to) => to < 40 && Math.abs((to % 8) - (from % 8)) <= 1)
      .map((to) => [from, to] as const),
  )
  return pairs.slice(0, 120).reduce((map, [from, to]) => addRoad(map, from, to), stations)
}

async function opens(child: Child, map: RoadMap) {
  await child.page.goto('/maps')
  const file = { name: 'map.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(writeMap(map, 'map')) }
  await child.button('design.new').waitFor()
  await child.page.locator('input[type=file]').first().setInputFiles(file)
  await child.page.locator('.frame').waitFor()
}

/** A station in the middle is pulled to and fro. */
async function pulls(page: Page) {
  const box = (await page.locator('.frame').boundingBox())!
  const at = (x: number, y: number) =>
    [box.x + (x / 1600) * box.width, box.y + (y / 1000) * box.height] as const
  await page.mouse.move(...at(700, 500))
  await page.mouse.down()
  await page.mouse.move(...at(720, 520))
  const watching = watchFrames(page, 5)
  for (let step = 0; step < 250; step += 1) {
    await page.mouse.move(...at(720 + 60 * Math.sin(step / 15), 520 + 50 * Math.cos(step / 15)))
    await page.waitForTimeout(16)
  }
  const watched = await watching
  await page.mouse.up()
  return watched
}

/** Seconds from the open map to “all tried”. */
async function tries(child: Child) {
  const began = performance.now()
  await child.words('design.tried').waitFor({ timeout: 120_000 })
  return (performance.now() - began) / 1000
}

async function measure(browser: Browser, url: string) {
  const map = largest()
  const child = await freshChild(browser, url)
  await opens(child, map)
  const seconds = await tries(child)
  await throttled(child.page)
  const watched = await pulls(child.page)
  await child.page.context().close()
  return { map, seconds, watched }
}

export default async function mapDesigner(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  try {
    const { map, seconds, watched } = await measure(browser, server.url)
    return {
      title: 'The largest map in the designer',
      how: `A map of ${map.stations.length} stations and ${map.roads.length} roads. A station with eight roads is pulled to and fro for five seconds, at a quarter of the processor (throttle ${throttle}); all roads are tried both ways by simulation at full speed, in two workers.`,
      columns: ['what', 'asked', 'measured'],
      rows: [
        ['a pulled station: between frames, p95', '≤ 18 ms', ms(percentile(watched.gaps, 0.95))],
        ['main thread a frame', '', ms(watched.perFrame)],
        [`all ${2 * map.roads.length} roads tried`, '≤ 10 s', `${seconds.toFixed(1)} s`],
      ],
      notes: frameNotes,
    }
  } finally {
    await browser.close()
    await server.close()
  }
}
