import type { Browser, Page } from '@playwright/test'
import { Child } from '../e2e/child.ts'
import { median, percentile } from './bench.ts'
import { noteFrames } from './in-page.ts'
import { mainThreadOf } from './trace.ts'

const categories = ['devtools.timeline', 'disabled-by-default-devtools.timeline', 'toplevel']

/** How much slower a slow laptop is than this machine. */
export const throttle = 4

export async function throttled(page: Page): Promise<Page> {
  const session = await page.context().newCDPSession(page)
  await session.send('Emulation.setCPUThrottlingRate', { rate: throttle })
  return page
}

/** The lab's usual window in a fresh profile, at full speed. @param density pixels of the screen per px */
export async function freshPage(browser: Browser, baseURL: string, density = 1): Promise<Page> {
  const viewport = { width: 1366, height: 768 }
  const context = await browser.newContext({
    baseURL,
    viewport,
    locale: 'en-GB',
    deviceScaleFactor: density,
  })
  return context.newPage()
}

/** A child in a fresh profile who is not offered the tour. */
export async function freshChild(browser: Browser, baseURL: string, density = 1): Promise<Child> {
  const page = await freshPage(browser, baseURL, density)
  await page.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  return new Child(page, 'en')
}

/**
 * The first visit keeps the whole lab for times without a network, in the background: what is measured comes after.
 * Once it is kept, it is so for every visit.
 */
export const untilKept = (page: Page) =>
  page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated')

/** Bytes in use after everything that nobody needs has been collected. */
export async function heapOf(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page)
  for (let time = 0; time < 3; time += 1) await session.send('HeapProfiler.collectGarbage')
  const { usedSize } = await session.send('Runtime.getHeapUsage')
  await session.detach()
  return usedSize
}

/** Distances between the frames noted since `noteFrames`, or since they were taken last. */
export async function takeGaps(page: Page): Promise<number[]> {
  const times = await page.evaluate(() => globalThis.frameTimes.splice(0))
  return times.slice(1).map((time, index) => time - times[index]!)
}

/** Distances between frames, and what the main thread does for them, while the page is left alone for some seconds. */
export const watchFrames = (page: Page, seconds: number) =>
  framesDuring(page, () => page.waitForTimeout(seconds * 1000))

/** Distances between frames, and what the main thread does for them, while something is done. */
export async function framesDuring(page: Page, act: () => Promise<void>) {
  const browser = page.context().browser()!
  await browser.startTracing(page, { categories })
  await page.evaluate(noteFrames)
  await act()
  const gaps = await takeGaps(page)
  const { tasks, frames } = mainThreadOf((await browser.stopTracing()).toString())
  const work = tasks.reduce((sum, task) => sum + task, 0)
  return {
    gaps,
    longest: Math.max(...tasks),
    perFrame: work / frames,
  }
}

export type Watched = Awaited<ReturnType<typeof framesDuring>>

/** So often each is measured, in turn with what it is compared with. */
export const rounds = Number(process.env['BOTGARTEN_ROUNDS'] ?? 5)

const spread = (values: readonly number[]) =>
  `${median(values).toFixed(1)} ms (${Math.min(...values).toFixed(1)} to ${Math.max(...values).toFixed(1)})`

export const frameColumns = [
  'between frames, 95th percentile',
  'median',
  'main thread a frame',
  'longest task',
] as const

/** Medians, least and most of what was watched again and again; as in `frameColumns`. */
export const frameCells = (all: readonly Watched[]): readonly string[] => [
  spread(all.map(({ gaps }) => percentile(gaps, 0.95))),
  spread(all.map(({ gaps }) => median(gaps))),
  spread(all.map(({ perFrame }) => perFrame)),
  spread(all.map(({ longest }) => longest)),
]

/** How frames are measured, for whoever reads a table. */
export const frameNotes = [
  'Headless, drawn by the processor: no graphics card helps. The throttle slows the main thread alone.',
  'Main thread and tasks: time of the processor, so that what other programs do meanwhile does not count.',
]
