import { readFileSync } from 'node:fs'
import type { Browser, Page } from '@playwright/test'
import { cardProject, readCard, type CardProgram, type WorldFile } from '@botgarten/content'
import { launchBrowser } from '../e2e/browser.ts'
import { Learner } from '../e2e/child-learning.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { ms, percentile, type Table } from './bench.ts'
import { freshChild, heapOf, throttle, throttled, watchFrames } from './slow.ts'

const tries = 10_000
const MB = (bytes: number) => `${(bytes / 1e6).toFixed(1)} MB`

/** The card City as a project file, with many tries. */
function manyTries(): string {
  const read = (path: string): unknown =>
    JSON.parse(readFileSync(new URL(`../content/${path}`, import.meta.url), 'utf8'))
  const folder = 'cards/q-learning/03-city'
  const text = JSON.stringify(read(`${folder}/start.json`))
    .replace('"EPISODES":"10"', `"EPISODES":"${tries}"`)
    .replace('"Q_LEARNER_TIME":"10000"', '"Q_LEARNER_TIME":"1000000"')
  const world = read('worlds/learning-city/world.json') as WorldFile
  const card = readCard(read(`${folder}/card.json`))
  return JSON.stringify(cardProject(world, card, JSON.parse(text) as CardProgram, 'City in turbo'))
}

/** A finger goes to and fro over all of the learning. */
async function scrubbing(page: Page, learner: Learner) {
  const box = (await learner.timeline.boundingBox())!
  const middle = box.y + box.height / 2
  await page.mouse.move(box.x + box.width / 2, middle)
  await page.mouse.down()
  const watching = watchFrames(page, 5)
  for (let step = 0; step < 250; step += 1) {
    await page.mouse.move(box.x + box.width * (0.5 + 0.48 * Math.sin(step / 20)), middle)
    await page.waitForTimeout(16)
  }
  const frames = await watching
  await page.mouse.up()
  return frames
}

async function city(browser: Browser, url: string) {
  const child = await freshChild(browser, url)
  const { page } = child
  const learner = new Learner(child)
  await learner.opens('city')
  await child.opensProject('City in turbo', manyTries())
  await learner.sees()
  const before = await heapOf(page)
  await learner.hurries()
  const watching = watchFrames(page, 12)
  await child.presses('q.play')
  await child.button('q.playNew').waitFor({ timeout: 60_000 })
  const turbo = await watching
  await child.button('lab.stop').first().click()
  const after = await heapOf(page)
  const { made } = await learner.moves()
  await throttled(page)
  const scrub = await scrubbing(page, learner)
  await page.context().close()
  return { before, after, made, turbo, scrub }
}

/** The City in turbo: ten thousand tries, and back and forth over all of it. */
export default async function qTurbo(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const { before, after, made, turbo, scrub } = await city(browser, server.url)
  await browser.close()
  await server.close()
  return {
    title: 'Learning by trying in the browser',
    how: `Chromium. The card City, ${tries} tries in turbo from the first move to the drawn way; then, at ${throttle} × CPU throttle, a hand goes to and fro on the timeline over all of it for five seconds.`,
    columns: ['what', 'measured', 'goal'],
    rows: [
      ['moves', made, ''],
      ['turbo: longest task of the main thread', ms(turbo.longest), '≤ 50 ms'],
      ['timeline: distance between frames, 95th percentile', ms(percentile(scrub.gaps, 0.95)), '≤ 18 ms'],
      ['… longest task of the main thread', ms(scrub.longest), ''],
      ['heap after collection, before', MB(before), ''],
      ['… with all of it learned', MB(after), ''],
    ],
    notes: [
      'A move takes 1000 ms at ×1 (500, 333 at ×2, ×3). Its phases begin at: where Bo is 0 ms, the decision and its dice 150 ms, the ride 400 ms, the reward 750 ms, the number that changes 850 ms. What a phase shows stays a whole move, until the next move reaches the same phase.',
    ],
  }
}
