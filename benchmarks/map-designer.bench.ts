import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Browser } from '@playwright/test'
import { content } from '@botgarten/content/files'
import { addRoad, addStation, emptyMap, faultsOf, openMap, setRoad, writeMap } from '@botgarten/maps/own'
import { changedDrawing } from '@botgarten/maps/own/testing'
import type { RoadMap } from '@botgarten/programs'
import fc from 'fast-check'
import { launchBrowser } from '../e2e/browser.ts'
import type { Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, percentile, type Table } from './bench.ts'
import { frameCells, framesDuring, freshChild, rounds, throttled, untilKept, type Watched } from './slow.ts'

const [columns, rows, most] = [8, 5, 120]

/** 40 stations in rows, moved a little; 120 roads to their neighbours, every third with a bend. The robot can drive them all. */
function large(): RoadMap {
  const places = Array.from({ length: columns * rows }, (_, k) => ({
    x: 82 + 205 * (k % columns) + (k % 3),
    y: 82 + 209 * Math.floor(k / columns) + (k % 2),
  }))
  const next = (k: number, across: number, down: number) => {
    const [column, row] = [(k % columns) + across, Math.floor(k / columns) + down]
    return column >= 0 && column < columns && row < rows ? [[k, row * columns + column] as const] : []
  }
  const steps = [[1, 0], [0, 1], [1, 1], [-1, 1]] as const // prettier-ignore
  const pairs = places.flatMap((_, k) => steps.flatMap(([across, down]) => next(k, across, down)))
  const stations = places.reduce(addStation, emptyMap('large'))
  const map = pairs.slice(0, most).reduce((map, [from, to]) => addRoad(map, from, to), stations)
  return map.roads.reduce((bent, { from, to }, index) => {
    if (index % 3 > 0) return bent
    const [a, b] = [bent.stations[from]!, bent.stations[to]!]
    const bends = [{ x: Math.round((a.x + b.x) / 2) + 12, y: Math.round((a.y + b.y) / 2) + 12 }]
    return setRoad(bent, index, { bends })
  }, map)
}

const roads = (map: RoadMap) => 2 * map.roads.length

async function opens(child: Child, svg: string) {
  await child.page.goto('/maps')
  const file = { name: 'large.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(svg) }
  await child.page.locator('input[type=file]').first().setInputFiles(file)
  await child.page.getByRole('group', { name: child.word('design.paper'), exact: true }).waitFor()
}

/** From the map on the screen until all its roads are tried in both directions, in ms: the pause after the last stroke too. */
async function tries(browser: Browser, url: string, map: RoadMap): Promise<number> {
  const child = await freshChild(browser, url)
  await child.page.goto('/maps')
  await untilKept(child.page)
  await opens(child, writeMap(map, 'large'))
  const started = Date.now()
  const all = child.word('design.triedCount', { count: roads(map), all: roads(map) })
  await child.page.getByText(all, { exact: true }).waitFor({ timeout: 120_000 })
  const milliseconds = Date.now() - started
  await child.page.context().close()
  return milliseconds
}

/** A station in the middle, with eight roads, is pulled to and fro. */
async function drags(browser: Browser, url: string, map: RoadMap): Promise<Watched> {
  const child = await freshChild(browser, url)
  const { page } = child
  await page.goto('/maps')
  await untilKept(page)
  await opens(child, writeMap(map, 'large'))
  const all = child.word('design.triedCount', { count: roads(map), all: roads(map) })
  await page.getByText(all, { exact: true }).waitFor({ timeout: 120_000 })
  await throttled(page)
  const { x, y } = await child.middleOf(child.button('design.station', { station: 19 }))
  await page.mouse.move(x, y)
  await page.mouse.down()
  const watched = await framesDuring(page, async () => {
    const end = Date.now() + 4000
    for (let step = 0; Date.now() < end; step += 1) {
      await page.mouse.move(x + 30 * Math.sin(step / 8), y + 20 * Math.cos(step / 8))
      await page.waitForTimeout(8)
    }
  })
  await page.mouse.up()
  await page.context().close()
  return watched
}

/** Milliseconds of the processor for each of 2,000 changed drawings. */
function changed(): readonly number[] {
  const folder = join(import.meta.dirname, '..', 'packages', 'maps', 'reference', 'drawings')
  const foreign = readdirSync(folder).filter((name) => name.endsWith('.svg'))
  const files = [...foreign.map((name) => readFileSync(join(folder, name), 'utf8')), writeMap(large(), 'own')]
  const known = JSON.parse(readFileSync(content.path('words', 'en', 'map-designer.json'), 'utf8')) as {
    design: { problem: Record<string, string> }
  }
  return fc.sample(changedDrawing(files), { numRuns: 2000, seed: 2026 }).map((text) => {
    const before = process.threadCpuUsage()
    const opened = openMap(text, 'mine')
    const { user, system } = process.threadCpuUsage(before)
    const problems = opened.map === null ? opened.problems : []
    if (problems.some(({ kind }) => !(kind in known.design.problem)))
      throw new Error('Refused without a word.')
    return (user + system) / 1000
  })
}

/** The largest map that a child may draw: how it feels on a slow laptop, and how long Bo tries its roads; and broken files. */
export default async function mapDesigner(): Promise<Table> {
  await buildWhenNeeded()
  const map = large()
  if (faultsOf(map).length > 0) throw new Error('The robot cannot drive this map.')
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const [tried, watched]: [number[], Watched[]] = [[], []]
  for (let round = 0; round < rounds; round += 1) {
    tried.push(await tries(browser, server.url, map))
    watched.push(await drags(browser, server.url, map))
  }
  await browser.close()
  await server.close()
  const read = changed()
  const [p95, middle, work, longest] = frameCells(watched)
  return {
    title: 'The largest map that can be drawn',
    how: `40 stations, ${map.roads.length} roads. Chromium, 1366 × 768, ${rounds} times: medians, least and most. A station with eight roads is pulled to and fro for 4 s at 4 × throttle; all roads are tried in both directions at full speed, two workers; ${read.length} drawings of which some letters were changed are read or refused.`,
    columns: ['what', 'value', 'goal'],
    rows: [
      ['pull: between frames, 95th percentile', p95!, '≤ 18 ms'],
      ['pull: between frames, median', middle!, ''],
      ['pull: main thread a frame', work!, ''],
      ['pull: longest task', longest!, ''],
      [`${roads(map)} roads tried, with the pause before`, `${ms(median(tried))} (${ms(Math.min(...tried))} to ${ms(Math.max(...tried))})`, '≤ 10 s'], // prettier-ignore
      ['a changed drawing: most', ms(Math.max(...read)), '≤ 200 ms'],
      ['a changed drawing: 99th percentile', ms(percentile(read, 0.99)), ''],
      ['a changed drawing: median', ms(median(read)), ''],
    ],
    notes: [
      'Headless, drawn by the processor: no graphics card helps. The throttle slows the main thread alone.',
      'Main thread, longest task and drawings: time of the processor, so that what other programs do meanwhile does not count.',
    ],
  }
}
