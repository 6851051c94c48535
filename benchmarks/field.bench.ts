import { resolve } from 'node:path'
import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import type { Table } from './bench.ts'
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

async function atFriendship(browser: Browser, url: string): Promise<Child> {
  const child = await freshChild(browser, url)
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
  // Released builds had a canvas of its own for it.
  const shown = child.page.getByRole('img', { name: child.word('inside.fieldPicture') })
  await shown.or(child.page.locator('.camera canvas')).first().waitFor({ state: 'attached' })
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

/** A knob is pulled without the field; readings are taken for it all over the floor; it is pulled with it. */
async function measure(browser: Browser, url: string): Promise<readonly Watched[]> {
  const child = await atFriendship(browser, url)
  const { page } = child
  await throttled(page)
  // The whole floor, and with it every arrow, is in sight.
  await child.presses('world.all')
  const without = await framesDuring(page, () => pulls(page, child, 4))
  await child.typesWeight(rightEye, rightWheel, 0.8)
  const reading = await framesDuring(page, async () => {
    await showsField(child)
    await page.waitForTimeout(3000)
  })
  const pulling = await framesDuring(page, () => pulls(page, child, 6))
  await page.context().close()
  return [without, reading, pulling]
}

const acts = ['knob pulled without the field', 'readings taken for the field', 'knob pulled with the field']

/** The field of arrows on a slow laptop; beside another checkout, built, whose folder BOTGARTEN_BESIDE names. */
export default async function field(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const places = [
    ...(beside ? [{ name: 'the other', server: await serverOf(resolve(beside)) }] : []),
    { name: 'this', server: await startServer({ port: 0, host: '127.0.0.1' }) },
  ].map((place) => ({ ...place, runs: [] as (readonly Watched[])[] }))
  const browser = await launchBrowser()
  for (let round = 0; round < rounds; round += 1)
    for (const { server, runs } of places) runs.push(await measure(browser, server.url))
  await browser.close()
  await Promise.all(places.map(({ server }) => server.close()))
  return {
    title: 'The field of 400 arrows',
    how: `Friendship in Chromium at ${throttle} × CPU throttle, 1366 × 768, density 1; a knob is pulled to and fro with as many movements as the page takes, once the lab is kept for times without a network, ${rounds} times each, in turn: medians, least and most. Goals: 95th percentile ≤ 18 ms, no task over 50 ms.`,
    columns: ['what', ...frameColumns],
    rows: places.flatMap(({ name, runs }) =>
      acts.map((act, index) => {
        const all = runs.map((run) => run[index]!)
        return [`${name}, ${act}`, ...frameCells(all)]
      }),
    ),
    notes: frameNotes,
  }
}
