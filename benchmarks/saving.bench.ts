import { createHash } from 'node:crypto'
import { crc32, deflateSync } from 'node:zlib'
import type { Project } from '@botgarten/programs'
import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { rightEye, rightWheel, type Child } from '../e2e/child.ts'
import { projectFile } from '../e2e/projects.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { ms, percentile, type Table } from './bench.ts'
import { freshChild, throttle, throttled, untilKept } from './slow.ts'
import { tasksWithMark } from './trace.ts'

/** Letters of the picture that lies on the floor, as a project holds it. */
const letters = 4_000_000
const seconds = 10
const mark = 'a part of a save'

function piece(type: string, data: Buffer): Buffer {
  const named = Buffer.concat([Buffer.from(type), data])
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)]
  length.writeUInt32BE(data.length)
  sum.writeUInt32BE(crc32(named))
  return Buffer.concat([length, named, sum])
}

/** A PNG of one dot that is as heavy as a photo by a text in it: quickly painted, saved like any other. */
function heavyPicture(): Buffer {
  const head = Buffer.from([0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0])
  const text = Buffer.from(Array.from({ length: (letters * 3) / 4 - 100 }, (_, k) => 32 + ((k * 7919) % 90)))
  return Buffer.concat([
    Buffer.from('89504e470d0a1a0a', 'hex'),
    ...[
      piece('IHDR', head),
      piece('tEXt', text),
      piece('IDAT', deflateSync(Buffer.from([0, 200, 200, 200]))),
    ],
    piece('IEND', Buffer.alloc(0)),
  ])
}

function project(picture: boolean): string {
  const plain = JSON.parse(projectFile('friendship', 'start')) as Project
  if (!picture) return JSON.stringify({ ...plain, name: 'plain' })
  const png = heavyPicture()
  const asset = createHash('sha256').update(png).digest('hex')
  const assets = { [asset]: { type: 'image/png', base64: png.toString('base64') } }
  return JSON.stringify({ ...plain, name: 'heavy', world: { ...plain.world, floor: { asset } }, assets })
}

/** Every part of a save sets a mark in the browser's trace. */
function markSaves(name: string) {
  for (const store of [IDBObjectStore.prototype, IDBDatabase.prototype] as object[])
    for (const verb of ['put', 'get', 'getAllKeys', 'transaction']) {
      const act = Reflect.get(store, verb) as ((...given: unknown[]) => unknown) | undefined
      if (!act) continue
      Reflect.set(store, verb, function (this: unknown, ...given: unknown[]) {
        performance.mark(name)
        return act.apply(this, given)
      })
    }
}

/** Pulls a knob to and fro for some seconds. Returns the tasks that saves were part of. */
async function pull(child: Child): Promise<readonly number[]> {
  const { page } = child
  const browser = page.context().browser()!
  const { x, y } = await child.middleOf(child.knob(rightEye, rightWheel))
  await page.mouse.move(x, y)
  await page.mouse.down()
  await browser.startTracing(page, {
    categories: ['toplevel', 'disabled-by-default-devtools.timeline', 'blink.user_timing'],
  })
  const end = Date.now() + seconds * 1000
  for (let step = 0; Date.now() < end; step += 1) {
    await page.mouse.move(x + 40 * Math.sin(step / 6), y)
    await page.waitForTimeout(30)
  }
  const trace = (await browser.stopTracing()).toString()
  await page.mouse.up()
  return tasksWithMark(trace, mark)
}

async function tasks(browser: Browser, url: string, picture: boolean): Promise<readonly number[]> {
  const child = await freshChild(browser, url)
  await child.page.addInitScript(markSaves, mark)
  await child.opensLab('friendship')
  await untilKept(child.page)
  await child.opensProject(picture ? 'heavy' : 'plain', project(picture))
  await child.reloads()
  await throttled(child.page)
  const found = await pull(child)
  await child.page.context().close()
  return found
}

/** What a save costs while a hand pulls a knob. */
export default async function saving(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const rows: (readonly string[])[] = []
  for (const picture of [false, true]) {
    const found = await tasks(browser, server.url, picture)
    rows.push([
      picture ? `a picture of ${letters / 1e6} MB on the floor` : 'no picture',
      String(found.length),
      ms(percentile(found, 0.5)),
      ms(percentile(found, 0.95)),
      ms(Math.max(...found)),
      '≤ 8 ms',
    ])
  }
  await browser.close()
  await server.close()
  return {
    title: 'Saving while a knob is pulled',
    how: `Friendship in Chromium at ${throttle} × CPU throttle, 1366 × 768; a knob is pulled to and fro for ${seconds} seconds. Tasks of the main thread in which a save reads, checks or writes anything.`,
    columns: ['project', 'tasks', 'median', '95th percentile', 'longest', 'goal'],
    rows,
    notes: ['A task holds whatever else the page does in it: the drawing of a frame, for instance.'],
  }
}
