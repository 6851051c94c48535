import type { Page } from '@playwright/test'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from './child.ts'

/** Everything is on the device, and this page is served from there: the cable can be pulled. */
export async function isKept(page: Page) {
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated')
}

/** In the lab two weights are set, Bo drives, and the work is saved. */
export async function setsDrivesAndSaves(child: Child) {
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await child.typesWeight(rightEye, rightWheel, 0.8)
  await child.pressesStart()
  await child.seesDriving()
  await child.pressesStop()
  await child.seesSaved()
}
