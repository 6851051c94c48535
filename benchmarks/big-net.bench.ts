import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Child } from '../e2e/child.ts'
import { deepNet } from '../e2e/projects.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { ms, percentile, type Table } from './bench.ts'
import { noteFrames } from './in-page.ts'
import { freshPage, takeGaps, throttled, untilKept } from './slow.ts'

const seconds = 8

interface Measured {
  readonly rest: readonly number[]
  readonly pan: readonly number[]
  /** The same hand at full speed, before. */
  readonly fast: readonly number[]
  /** Of the knobs that are drawn: the smallest side of what a finger takes hold of, in px. */
  readonly knob: number
  readonly knobs: number
  readonly stage: { readonly width: number; readonly height: number }
}

/** A hand on a wheel: 30 notches a second, to the right and back, down and up. Gives the distances between frames. */
async function pans(page: Page): Promise<number[]> {
  await page.evaluate(noteFrames)
  const end = Date.now() + seconds * 1000
  for (let notch = 0; Date.now() < end; notch += 1) {
    const way = notch % 120 < 60 ? 1 : -1
    await page.mouse.wheel(18 * way, 9 * way)
    await page.waitForTimeout(33)
  }
  return takeGaps(page)
}

/** Pans over a net of 200 neurons, at full speed and on a slow laptop. */
async function panOn(browser: Browser, baseURL: string): Promise<Measured> {
  const page = await freshPage(browser, baseURL)
  const child = new Child(page, 'en')
  await child.opensLab('free')
  await child.opensProject('Deep', deepNet('Deep'))
  await child.knobs.first().waitFor()
  const sizes = await child.knobs.evaluateAll((knobs) =>
    knobs.map((knob) => Math.min(knob.clientWidth, knob.clientHeight)),
  )
  const scroll = page.locator('.playground .scroll')
  const stage = await scroll.evaluate(({ scrollWidth, scrollHeight }) => ({
    width: scrollWidth,
    height: scrollHeight,
  }))
  await untilKept(page)
  await scroll.hover()
  const fast = await pans(page)
  await throttled(page)
  await page.waitForTimeout(1500)
  await page.evaluate(noteFrames)
  await page.waitForTimeout(3000)
  const rest = await takeGaps(page)
  const pan = await pans(page)
  await page.context().close()
  return { rest, pan, fast, knob: Math.min(...sizes), knobs: sizes.length, stage }
}

/** 200 neurons on the screen. */
export default async function bigNet(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const { rest, pan, fast, knob, knobs, stage } = await panOn(browser, server.url)
  await browser.close()
  await server.close()
  return {
    title: 'A network of 200 neurons',
    how: `Chromium without a graphics card, 1366 × 768, at full speed and with the processor at a quarter, once the lab is kept for times without a network; ten layers of 20 neurons, 3,600 links, panned by the wheel for ${seconds} seconds; the stage is ${stage.width} × ${stage.height} px.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      ['what a finger takes hold of at a knob', `${knob} px`, '≥ 44 px'],
      ['full speed: frame while panning, median', ms(percentile(fast, 0.5)), '16.7 ms'],
      ['… p95', ms(percentile(fast, 0.95)), '≤ 18 ms'],
      ['… longest', ms(Math.max(...fast)), ''],
      ['a quarter: frame while panning, median', ms(percentile(pan, 0.5)), '16.7 ms'],
      ['… p95', ms(percentile(pan, 0.95)), '≤ 18 ms'],
      ['… longest', ms(Math.max(...pan)), ''],
      ['… frame at rest before, p95', ms(percentile(rest, 0.95)), ''],
      ['links drawn of 3,600', String(knobs), ''],
    ],
  }
}
