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

/** The lab's usual window in a fresh profile, at full speed. The tour is not offered. */
export async function freshChild(browser: Browser, baseURL: string): Promise<Child> {
  const viewport = { width: 1366, height: 768 }
  const context = await browser.newContext({ baseURL, viewport, locale: 'en-GB' })
  await context.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  return new Child(await context.newPage(), 'en')
}

/** Distances between frames, and what the main thread does for them, while the page is left alone for some seconds. */
export async function watchFrames(page: Page, seconds: number) {
  const browser = page.context().browser()!
  await browser.startTracing(page, { categories })
  await page.evaluate(noteFrames)
  await page.waitForTimeout(seconds * 1000)
  const times = await page.evaluate(() => globalThis.frameTimes)
  const { tasks, frames } = mainThreadOf((await browser.stopTracing()).toString())
  const work = tasks.reduce((sum, task) => sum + task, 0)
  return {
    gaps: times.slice(1).map((time, index) => time - times[index]!),
    longest: Math.max(...tasks),
    perFrame: work / frames,
  }
}
