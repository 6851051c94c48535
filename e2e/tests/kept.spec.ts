// Rooms: storage
import type { BrowserContext, CDPSession, Page } from '@playwright/test'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** Lets the browser believe that the disk has room for so many bytes; undefined: as much as there is. */
async function roomFor(session: CDPSession, origin: string, quotaSize?: number) {
  await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize })
}

const weightIn = (file: string, from: string, to: string) =>
  (JSON.parse(file) as { brains: { net: { weights: Record<string, Record<string, number>> } } }).brains.net
    .weights[from]?.[to]

/** Ends the page's process, as a browser does that runs out of memory. */
async function crash(page: Page, context: BrowserContext) {
  const session = await context.newCDPSession(page)
  const crashed = page.waitForEvent('crash')
  session.send('Page.crash').catch(() => 'a page that has crashed does not answer')
  await crashed
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('on a full disk is told so, keeps working, takes the work along as a file, and saves when there is room', async ({
      child,
      page,
      context,
      house,
    }) => {
      await child.opensLab('friendship')
      // Before the first save: Chromium believes for half a minute in the room that it has seen.
      const session = await context.newCDPSession(page)
      await roomFor(session, house, 1)

      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.typesWeight(rightEye, rightWheel, 0.7)
      const alert = page.getByRole('alert').filter({ hasText: child.word('lab.fullTitle') })
      await expect(alert).toContainText(child.word('lab.fullText'))
      const retry = page.getByRole('button', { name: child.word('lab.notSaved') })
      await expect(retry).toBeVisible()
      await child.seesWeight(leftEye, leftWheel, 0.4)
      await child.seesWeight(rightEye, rightWheel, 0.7)
      const file = await child.takesFile()
      expect([weightIn(file, 'eyeLeft', 'wheelLeft'), weightIn(file, 'eyeRight', 'wheelRight')]).toEqual([
        0.4, 0.7,
      ])

      await roomFor(session, house)
      await retry.click()
      await child.seesSaved()
      await expect(alert).toBeHidden()
      await child.reloads()
      await child.seesWeight(rightEye, rightWheel, 0.7)
    })

    test('whose browser keeps nothing is told so before work is lost, and takes it along as a file', async ({
      child,
      page,
    }) => {
      await page.addInitScript(() => {
        const refuse = () => {
          throw new DOMException('Refused for a test.', 'SecurityError')
        }
        Object.defineProperty(IDBFactory.prototype, 'open', { value: refuse })
        Object.defineProperty(window, 'localStorage', { get: refuse })
      })
      await child.opensHome()
      await child.opensLab('friendship')
      const chip = page.getByRole('button', { name: child.word('lab.notSaved') })
      await expect(chip).toBeVisible()
      await chip.click()
      await expect(chip).toBeVisible()
      await expect(child.words('lab.saved')).toHaveCount(0)
      await child.typesWeight(leftEye, leftWheel, 0.4)
      const alert = page.getByRole('alert').filter({ hasText: child.word('lab.refusedTitle') })
      await expect(alert).toContainText(child.word('lab.refusedText'))
      expect(weightIn(await child.takesFile(), 'eyeLeft', 'wheelLeft')).toBe(0.4)
      await child.pressesStart()
      await child.seesDriving()
    })

    test('finds everything again after a crash', async ({ child, page, context }) => {
      await child.opensLab('friendship')
      await child.asksHint()
      await child.typesWeight(leftEye, leftWheel, 0.35)
      await child.addsNeuron('addMotor')
      await expect(child.knobs).toHaveCount(6)
      await child.seesSaved()
      const words = await child.blockWords()
      await crash(page, context)

      const again = new Child(await context.newPage(), language)
      await again.opensHome()
      await again.opensLab('friendship')
      await again.seesWeight(leftEye, leftWheel, 0.35)
      await expect(again.knobs).toHaveCount(6)
      await expect.poll(() => again.blockWords()).toEqual(words)
    })
  })
}
