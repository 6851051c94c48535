import type { Browser, Page } from '@playwright/test'
import { Child } from '../e2e/child.ts'
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

/** The lab's usual window in a fresh profile, at full speed. */
export async function freshPage(browser: Browser, baseURL: string): Promise<Page> {
  const viewport = { width: 1366, height: 768 }
  const context = await browser.newContext({ baseURL, viewport, locale: 'en-GB' })
  return context.newPage()
}

/** A child in a fresh profile who is not offered the tour. */
export async function freshChild(browser: Browser, baseURL: string): Promise<Child> {
  const page = await freshPage(browser, baseURL)
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
