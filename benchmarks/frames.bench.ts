import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, percentile, type Table } from './bench.ts'
import { answered, askFramesUntilChange, askMillisecondsToMove, noteFrames } from './in-page.ts'
import { freshPage, throttle, throttled, untilKept, watchFrames } from './slow.ts'

/** A slow laptop: a fresh profile, the lab's usual window, the processor at a quarter. */
async function slowChild(browser: Browser, baseURL: string): Promise<Child> {
  return new Child(await throttled(await freshPage(browser, baseURL)), 'en')
}

/** Friendship drives for ten seconds with all panes live. */
async function driving(browser: Browser, url: string) {
  const child = await slowChild(browser, url)
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.typesWeight(leftEye, rightWheel, 0.25)
  await untilKept(child.page)
  await child.pressesStart()
  await child.page.waitForTimeout(2000)
  const watched = await watchFrames(child.page, 10)
  await child.page.context().close()
  return watched
}

/** The knob is pulled while the robot stands; frames until the wheel's number has changed. */
async function knobs(browser: Browser, url: string): Promise<number[]> {
  const child = await slowChild(browser, url)
  await child.opensLab('friendship')
  await child.pressesStart()
  await child.page.evaluate(noteFrames)
  const frames: number[] = []
  for (let pull = 0; pull < 10; pull += 1) frames.push(await onePull(child))
  await child.page.context().close()
  return frames
}

async function onePull(child: Child): Promise<number> {
  const { page } = child
  const knob = child.knob(rightEye, rightWheel)
  const box = (await knob.boundingBox())!
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await child.output(rightWheel).evaluate(askFramesUntilChange)
  await page.mouse.move(x + 60, y)
  const frames = await page.evaluate(answered)
  await page.mouse.up()
  await knob.press('Home')
  return frames
}

/** The first click on Start in a fresh browser, and on the home page's one-click drive. */
async function firstMove(browser: Browser, url: string): Promise<number> {
  const child = await slowChild(browser, url)
  await child.opensLab('free')
  await child.bo.evaluate(askMillisecondsToMove)
  await child.button('lab.start').click()
  const milliseconds = await child.page.evaluate(answered)
  await child.page.context().close()
  return milliseconds
}

async function inFreshBrowsers(url: string, times: number): Promise<number[]> {
  const all: number[] = []
  for (let run = 0; run < times; run += 1) {
    const browser = await launchBrowser()
    all.push(await firstMove(browser, url))
    await browser.close()
  }
  return all
}

/** How the lab feels on a slow laptop. */
export default async function frames(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const { gaps, longest, perFrame } = await driving(browser, server.url)
  const pulls = await knobs(browser, server.url)
  await browser.close()
  const starts = await inFreshBrowsers(server.url, 5)
  await server.close()
  return {
    title: 'The lab on a slow laptop',
    how: `Chromium at ${throttle} × CPU throttle, 1366 × 768, all panes live; ten seconds of driving once the lab is kept for times without a network, ten pulls at a knob, five first clicks in fresh browsers.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      ['distance between frames, 95th percentile', ms(percentile(gaps, 0.95)), '≤ 18 ms'],
      ['distance between frames, median', ms(median(gaps)), ''],
      ['main thread a frame, mean of a trace', ms(perFrame), '≤ 6 ms'],
      ['longest task of the main thread', ms(longest), '≤ 50 ms'],
      [
        'knob moved → number of the motor changed, worst of ten',
        `${Math.max(...pulls)} frames`,
        '≤ 2 frames',
      ],
      ['first click on Start → first changed pose, worst of five', ms(Math.max(...starts)), '≤ 1000 ms'],
    ],
    notes: ['Headless, drawn by the processor: no graphics card helps.'],
  }
}
