import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Browser } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { serverOf } from './beside.ts'
import { ms, type Table } from './bench.ts'
import { answered, askFramesUntilChange, askMillisecondsToMove, noteFrames } from './in-page.ts'
import {
  frameCells,
  frameColumns,
  frameNotes,
  freshChild,
  freshPage,
  rounds,
  throttle,
  throttled,
  untilKept,
  watchFrames,
  type Watched,
} from './slow.ts'

/** A slow laptop: a fresh profile, the lab's usual window, the processor at a quarter. */
async function slowChild(browser: Browser, baseURL: string): Promise<Child> {
  return new Child(await throttled(await freshPage(browser, baseURL)), 'en')
}

interface Standing {
  readonly id: string
  readonly pose: { readonly x: number; readonly y: number; readonly heading: number }
}

interface Saved {
  readonly world: { readonly robots: readonly Standing[]; readonly obstacles: readonly Standing[] }
}

/** Friendship's project with more robots, side by side, each with the same program. */
function withRobots(project: Saved, count: number): Saved {
  const [bo] = project.world.robots
  const robots = Array.from({ length: count }, (_, index) => ({
    ...bo!,
    id: index === 0 ? bo!.id : `bo${index + 1}`,
    pose: { ...bo!.pose, y: bo!.pose.y - 30 * index },
  }))
  return { ...project, world: { ...project.world, robots } }
}

/** The same with small things that can be pushed, in rows beside where Bo drives. */
function withThings(project: Saved, count: number): Saved {
  const things = Array.from({ length: count }, (_, index) => ({
    id: `thing${index + 1}`,
    shape: index % 2 === 0 ? { kind: 'circle', radius: 5 } : { kind: 'rectangle', width: 9, height: 9 },
    pose: { x: 20 + 14 * (index % 10), y: 30 + 14 * Math.floor(index / 10), heading: 0 },
    fixed: false,
    colour: '#F7D117',
  }))
  return { ...project, world: { ...project.world, obstacles: things } }
}

/** What drives, and what the sketch has of it; without `change` it is the card as it opens. */
interface Course {
  readonly name: string
  readonly change?: (project: Saved) => Saved
  readonly sketched?: number
  readonly density?: number
}

const courses: readonly Course[] = [
  { name: 'one robot', sketched: 1 },
  { name: 'four robots', change: (project) => withRobots(project, 4), sketched: 4 },
  { name: '40 things', change: (project) => withThings(project, 40) },
  { name: 'one robot, density 2', density: 2 },
]

const seconds = 5

/** Robots drive with all panes live. The lab is opened at full speed. */
async function driving(browser: Browser, url: string, { change, density }: Course) {
  const child = await freshChild(browser, url, density)
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.typesWeight(leftEye, rightWheel, 0.25)
  await untilKept(child.page)
  if (change) {
    const project = change(JSON.parse(await child.savesFile()) as Saved)
    await child.opensProject('Robots', JSON.stringify({ ...project, name: 'Robots' }))
  }
  await throttled(child.page)
  await child.pressesStart()
  await child.page.waitForTimeout(1500)
  const watched = await watchFrames(child.page, seconds)
  await child.page.context().close()
  return watched
}

/** Two canvases with what a lab shows: what a frame costs at least. */
async function sketch(browser: Browser, path: string, robots: number) {
  const page = await throttled(await freshPage(browser, 'http://localhost'))
  await page.goto(`${pathToFileURL(path).href}?robots=${robots}`)
  await page.waitForTimeout(2000)
  const watched = await watchFrames(page, seconds)
  await page.context().close()
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

/** What is measured in turn; null: it has no such course. */
interface Place {
  readonly name: string
  readonly drive: (course: Course) => Promise<Watched> | null
  readonly watched: ReadonlyMap<Course, Watched[]>
}

function rowsOf({ name, watched }: Place): readonly (readonly string[])[] {
  const driven = [...watched].filter(([, all]) => all.length > 0)
  return driven.map(([course, all]) => [`${name}, ${course.name}`, ...frameCells(all)])
}

/**
 * How the lab feels on a slow laptop; beside another checkout, built, whose folder BOTGARTEN_BESIDE names, and a page
 * that BOTGARTEN_SKETCH names.
 */
export default async function frames(): Promise<Table> {
  await buildWhenNeeded()
  const beside = process.env['BOTGARTEN_BESIDE']
  const path = process.env['BOTGARTEN_SKETCH']
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const other = beside ? await serverOf(resolve(beside)) : null
  const browser = await launchBrowser()
  const places: readonly Place[] = [
    ...(other ? [{ name: 'the other', drive: (course: Course) => driving(browser, other.url, course) }] : []),
    { name: 'this', drive: (course: Course) => driving(browser, server.url, course) },
    ...(path
      ? [
          {
            name: 'the sketch',
            drive: ({ sketched }: Course) => (sketched ? sketch(browser, path, sketched) : null),
          },
        ]
      : []),
  ].map((one) => ({ ...one, watched: new Map(courses.map((course) => [course, [] as Watched[]])) }))
  for (let round = 0; round < rounds; round += 1)
    for (const { drive, watched } of places)
      for (const [course, all] of watched) {
        const run = await drive(course)
        if (run) all.push(run)
      }
  const pulls = await knobs(browser, server.url)
  await browser.close()
  const starts = await inFreshBrowsers(server.url, 5)
  await Promise.all([server.close(), other?.close()])
  return {
    title: 'The lab on a slow laptop',
    how: `Chromium at ${throttle} × CPU throttle, 1366 × 768, density 1 where no other is named, all panes live; ${seconds} seconds of driving on Friendship once the lab is kept for times without a network, ${rounds} times each, in turn: medians, least and most. Goals: 95th percentile ≤ 18 ms; ≤ 13 ms a frame with one robot, ≤ 16 with four.`,
    columns: ['what', ...frameColumns],
    rows: places.flatMap(rowsOf),
    notes: [
      ...frameNotes,
      `Knob moved → number of the motor changed: ${Math.max(...pulls)} frames at most in ten pulls (goal: 2).`,
      `First click on Start → first changed pose: ${ms(Math.max(...starts))} at most in five fresh browsers (goal: 1000 ms).`,
    ],
  }
}
