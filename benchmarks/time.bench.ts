import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { leftEye, leftWheel, rightWheel } from '../e2e/child.ts'
import { TimeHands } from '../e2e/child-time.ts'
import { bundle } from '../e2e/runs/in-browser.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, percentile, type Table } from './bench.ts'
import type { Moments, Steps } from './moments.ts'
import { freshChild, heapOf, throttle, throttled, watchFrames } from './slow.ts'

const jumps = 300
const MB = (bytes: number) => `${(bytes / 1e6).toFixed(1)} MB`

type Bench = { moments(count: number): Moments[]; steps(minutes: number): Steps[] }

/** The lab alone, bundled into an empty page. */
async function aloneIn(page: Page): Promise<Page> {
  await page.addScriptTag({ content: await bundle(new URL('moments.ts', import.meta.url), 'bench') })
  return page
}

async function momentsIn(browser: Browser): Promise<Moments[]> {
  const page = await aloneIn(await throttled(await browser.newPage()))
  const found = await page.evaluate(
    (count) => (globalThis as unknown as { bench: Bench }).bench.moments(count),
    jumps,
  )
  await page.close()
  return found
}

/** At full speed. */
async function stepsIn(browser: Browser): Promise<Steps[]> {
  const page = await aloneIn(await browser.newPage())
  const found = await page.evaluate(
    (minutes) => (globalThis as unknown as { bench: Bench }).bench.steps(minutes),
    5,
  )
  await page.close()
  return found
}

async function untilSecond(time: TimeHands, page: Page, seconds: number) {
  while ((await time.at()) < seconds) await page.waitForTimeout(200)
}

/** The median of five readings in the five minutes from here: what is kept of ten minutes swings with what they held. */
async function heapFrom(minutes: number, time: TimeHands, page: Page): Promise<number> {
  const readings: number[] = []
  for (let reading = 0; reading < 5; reading += 1) {
    await untilSecond(time, page, (minutes + reading) * 60)
    readings.push(await heapOf(page))
  }
  return median(readings)
}

/** Milliseconds from a finger on the slider to the frame that shows the moment, at places all over ten minutes. */
async function touches(page: Page, time: TimeHands): Promise<number[]> {
  const box = (await time.slider.boundingBox())!
  const took: number[] = []
  for (let touch = 0; touch < 40; touch += 1) {
    const x = box.x + 24 + ((touch * 0.37) % 1) * (box.width - 80)
    // Listening is known to have begun before the finger comes: what begins later would wait for ever.
    await time.slider.evaluate((slider) => {
      const before = slider.getAttribute('aria-valuenow')
      const shown = new Promise<number>((done) => {
        slider.addEventListener(
          'pointerdown',
          ({ timeStamp }) => {
            const look = () =>
              slider.getAttribute('aria-valuenow') === before && performance.now() - timeStamp < 5000
                ? requestAnimationFrame(look)
                : done(performance.now() - timeStamp)
            requestAnimationFrame(look)
          },
          { once: true },
        )
      })
      Object.assign(window, { shown })
    })
    await page.mouse.click(x, box.y + 24)
    took.push(await page.evaluate(() => (window as unknown as { shown: Promise<number> }).shown))
  }
  return took
}

/** A finger goes to and fro on the slider for five seconds. */
async function scrubbing(page: Page, time: TimeHands) {
  const box = (await time.slider.boundingBox())!
  const middle = box.y + 24
  await page.mouse.move(box.x + 40, middle)
  await page.mouse.down()
  const watching = watchFrames(page, 5)
  for (let step = 0; step < 250; step += 1) {
    await page.mouse.move(box.x + 40 + 200 * Math.abs(Math.sin(step / 20)), middle)
    await page.waitForTimeout(16)
  }
  const frames = await watching
  await page.mouse.up()
  return frames
}

/** Bo circles for a simulated hour, as fast as it can. */
async function hour(browser: Browser, url: string) {
  const child = await freshChild(browser, url)
  const time = new TimeHands(child)
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.typesWeight(leftEye, rightWheel, 0.25)
  await child.pressesStart()
  await time.opens()
  await time.chooses('Infinity')
  const full = await heapFrom(15, time, child.page)
  const after = await heapFrom(60, time, child.page)
  await child.presses('lab.pause')
  await throttled(child.page)
  const took = await touches(child.page, time)
  const scrub = await scrubbing(child.page, time)
  await child.page.context().close()
  return { full, after, took, scrub }
}

/** Back to any moment, and an hour without growing. */
export default async function time(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const steps = await stepsIn(browser)
  const alone = await momentsIn(browser)
  const { full, after, took, scrub } = await hour(browser, server.url)
  await browser.close()
  await server.close()
  return {
    title: 'The time machine',
    how: `Chromium at ${throttle} × CPU throttle. ${jumps} random moments of ten minutes with hands in them, each compared with the hash that the original had there; then the lab's own page after a simulated hour, as fast as it can.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      ...steps.map(({ name, perStep }) => [
        `a step of simulation and program in a page at full speed, ${name}: median of the means of five minutes (least to most)`,
        `${median(perStep).toFixed(4)} ms (${Math.min(...perStep).toFixed(4)} to ${Math.max(...perStep).toFixed(4)})`,
        name === 'four robots' ? '' : '≤ 0.05 ms',
      ]),
      ...alone.flatMap(({ name, took: each, equal }) => [
        [`a moment of ten minutes: ${name}, slowest of ${jumps}`, ms(Math.max(...each)), '≤ 100 ms'],
        [`… 95th percentile`, ms(percentile(each, 0.95)), ''],
        [`… hash equal to the original's`, `${equal} of ${jumps}`, `${jumps} of ${jumps}`],
      ]),
      [
        'finger on the slider → frame that shows the moment, slowest of 40',
        ms(Math.max(...took)),
        '≤ 100 ms',
      ],
      ['… 95th percentile', ms(percentile(took, 0.95)), ''],
      [
        'finger to and fro: distance between frames, 95th percentile',
        ms(percentile(scrub.gaps, 0.95)),
        '≤ 18 ms',
      ],
      ['… longest task of the main thread', ms(scrub.longest), '≤ 50 ms'],
      ['heap after collection, 15 minutes of running', MB(full), ''],
      ['heap after collection, one hour of running', MB(after), ''],
      ['growth', `${((after / full - 1) * 100).toFixed(1)} %`, '≤ 10 %'],
    ],
    notes: [
      'At 15 minutes the ten minutes that are kept are full; medians of five readings, a simulated minute apart, are compared; the heap is measured at full speed, without throttle.',
    ],
  }
}
