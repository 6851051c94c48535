import { resolve } from 'node:path'
import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { deepNet } from '../e2e/projects.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import type { Table } from './bench.ts'
import { placesThatAnswer } from './in-page.ts'
import {
  frameCells,
  frameColumns,
  frameNotes,
  framesDuring,
  freshChild,
  rounds,
  throttle,
  throttled,
  untilKept,
  type Watched,
} from './slow.ts'

const seconds = 6

interface Measured {
  readonly fast: Watched
  readonly slow: Watched
  /** Of places around the knobs that are seen: how many answer to a hand, of how many. */
  readonly answering: { readonly answer: number; readonly places: number }
  readonly knobs: number
  readonly stage: { readonly width: number; readonly height: number }
}

/** A hand on a wheel: 30 notches a second, to the right and back, down and up. */
async function pans(page: Page): Promise<void> {
  const end = Date.now() + seconds * 1000
  for (let notch = 0; Date.now() < end; notch += 1) {
    const way = notch % 120 < 60 ? 1 : -1
    await page.mouse.wheel(18 * way, 9 * way)
    await page.waitForTimeout(33)
  }
}

/** Pans over a net of 200 neurons, at full speed and on a slow laptop. */
async function panOn(browser: Browser, baseURL: string): Promise<Measured> {
  const child = await freshChild(browser, baseURL)
  const { page } = child
  await child.opensLab('free')
  await child.opensProject('Deep', deepNet('Deep'))
  await child.knobs.first().waitFor()
  const scroll = page.locator('.playground .scroll')
  const stage = await scroll.evaluate(({ scrollWidth, scrollHeight }) => ({
    width: scrollWidth,
    height: scrollHeight,
  }))
  await untilKept(page)
  const answering = await page.evaluate(placesThatAnswer, 22)
  const knobs = await child.knobs.count()
  await scroll.hover()
  const fast = await framesDuring(page, () => pans(page))
  await throttled(page)
  await page.waitForTimeout(1000)
  const slow = await framesDuring(page, () => pans(page))
  await page.context().close()
  return { fast, slow, answering, knobs, stage }
}

/** 200 neurons on the screen; beside another checkout, built, whose folder BOTGARTEN_BESIDE names. */
export default async function bigNet(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const places = [
    ...(beside ? [{ name: 'the other', server: await serverOf(resolve(beside)) }] : []),
    { name: 'this', server: await startServer({ port: 0, host: '127.0.0.1' }) },
  ].map((place) => ({ ...place, runs: [] as Measured[] }))
  const browser = await launchBrowser()
  for (let round = 0; round < rounds; round += 1)
    for (const { server, runs } of places) runs.push(await panOn(browser, server.url))
  await browser.close()
  await Promise.all(places.map(({ server }) => server.close()))
  const { answering, knobs, stage } = places.at(-1)!.runs[0]!
  return {
    title: 'A network of 200 neurons',
    how: `Chromium, 1366 × 768, density 1, at full speed and at ${throttle} × CPU throttle, once the lab is kept for times without a network; ten layers of 20 neurons, 3,600 links, panned by the wheel for ${seconds} seconds, ${rounds} times each, in turn: medians, least and most; the stage is ${stage.width} × ${stage.height} px. Goal: 95th percentile ≤ 18 ms.`,
    columns: ['what', ...frameColumns],
    rows: places.flatMap(({ name, runs }) => [
      [`${name}, full speed`, ...frameCells(runs.map(({ fast }) => fast))],
      [`${name}, ${throttle} × throttle`, ...frameCells(runs.map(({ slow }) => slow))],
    ]),
    notes: [
      ...frameNotes,
      `Of ${answering.places} places 22 px from the middle of a knob ${answering.answer} answer to a finger: with this knob, or with one that is nearer (goal: all; a knob answers within 44 px).`,
      `Links that answer before the first movement: ${knobs} of 3,600.`,
    ],
  }
}
