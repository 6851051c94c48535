import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, percentile, type Table } from './bench.ts'
import { framesDuring, freshChild, throttle, throttled, untilKept } from './slow.ts'

async function atFriendship(browser: Browser, url: string): Promise<Child> {
  const child = await freshChild(browser, url)
  await throttled(child.page)
  await child.opensLab('friendship')
  await untilKept(child.page)
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.typesWeight(leftEye, rightWheel, 0.3)
  await child.typesWeight(rightEye, rightWheel, 0.8)
  return child
}

async function showsField(child: Child) {
  await child.presses('lab.worldSettings')
  await child.page.getByRole('switch', { name: child.word('inside.field') }).setChecked(true, { force: true })
  await child.types('Escape')
  await child.page.locator('.camera canvas').waitFor()
}

/** Goes on pulling a knob to and fro for so many seconds, with as many movements as the page takes. */
async function pulls(page: Page, child: Child, seconds: number) {
  const box = (await child.knob(rightEye, rightWheel).boundingBox())!
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  const end = Date.now() + seconds * 1000
  for (let step = 0; Date.now() < end; step += 1) {
    await page.mouse.move(x - 30 - 30 * Math.sin(step / 8), y)
    await page.waitForTimeout(8)
  }
  await page.mouse.up()
}

/** The field of arrows on a slow laptop: while it is read, and while a knob is pulled. */
export default async function field(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const child = await atFriendship(browser, server.url)
  const { page } = child
  // The whole floor, and with it every arrow, is in sight.
  await child.presses('world.all')
  const without = await framesDuring(page, () => pulls(page, child, 5))
  await child.typesWeight(rightEye, rightWheel, 0.8)
  const reading = await framesDuring(page, async () => {
    await showsField(child)
    await page.waitForTimeout(3000)
  })
  const pulling = await framesDuring(page, () => pulls(page, child, 10))
  await browser.close()
  await server.close()
  return {
    title: 'The field of 400 arrows',
    how: `Friendship in Chromium at ${throttle} × CPU throttle, 1366 × 768; a knob is pulled to and fro with the field on the floor, with as many movements as the page takes, once the lab is kept for times without a network.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      [
        'distance between frames while a knob is pulled, 95th percentile',
        ms(percentile(pulling.gaps, 0.95)),
        '≤ 18 ms',
      ],
      ['distance between frames, median', ms(median(pulling.gaps)), ''],
      ['main thread a frame, mean of a trace', ms(pulling.perFrame), ''],
      ['longest task', ms(pulling.longest), '≤ 50 ms'],
      ['the same knob without the field, 95th percentile', ms(percentile(without.gaps, 0.95)), ''],
      ['main thread a frame without the field', ms(without.perFrame), ''],
      ['longest task while readings are taken all over the floor', ms(reading.longest), '≤ 50 ms'],
    ],
    notes: ['Headless, drawn by the processor: no graphics card helps.'],
  }
}
