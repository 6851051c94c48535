// Rooms: storage
import type { BrowserContext } from '@playwright/test'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf, type Language } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** A second tab on the same project. `deaf`: it does not hear what other tabs save. */
async function secondTab(context: BrowserContext, language: Language, deaf: boolean): Promise<Child> {
  const page = await context.newPage()
  if (deaf) await page.addInitScript('delete window.BroadcastChannel')
  const child = new Child(page, language)
  await child.opensLab('friendship')
  return child
}

/** The first tab saves 0.5, the second one 0.3 for another knob: it is told, and nothing is overwritten. */
async function savesInBoth(child: Child, other: Child) {
  await child.typesWeight(leftEye, leftWheel, 0.5)
  await child.seesSaved()
  await other.typesWeight(rightEye, rightWheel, 0.3)
  await expect(other.dialog('lab.conflictTitle')).toBeVisible()
}

const copied = (child: Child) => child.word('session.copy', { name: child.card('friendship') })
const link = (child: Child, name: string) => child.page.getByRole('link', { name })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`two tabs on one project, in ${language}`, () => {
    test.use({ language })

    test('a tab says at once that the other one has saved, and takes over what is newer', async ({
      child,
      context,
    }) => {
      await child.opensLab('friendship')
      const other = await secondTab(context, language, false)
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await expect(other.dialog('lab.conflictTitle')).toBeVisible()
      await other.types('Escape')
      await expect(other.dialog('lab.conflictTitle'), 'the child has to choose').toBeVisible()
      await other.presses('lab.loadNewer')
      await other.seesWeight(leftEye, leftWheel, 0.5)
      await other.typesWeight(leftEye, leftWheel, 0.6)
      await other.seesSaved()
      await expect(child.dialog('lab.conflictTitle')).toBeVisible()
    })

    test('"keep mine as a copy" keeps both', async ({ child, context }) => {
      await child.opensLab('friendship')
      const other = await secondTab(context, language, true)
      await savesInBoth(child, other)
      await other.presses('lab.keepCopy')
      await other.seesSaved()
      await other.seesWeight(rightEye, rightWheel, 0.3)
      await other.presses('lab.undo')
      await other.seesWeight(rightEye, rightWheel, 0)
      await other.presses('lab.redo')
      await other.seesWeight(rightEye, rightWheel, 0.3)
      await other.seesSaved()
      await other.reloads()
      await expect(other.page.getByRole('heading', { level: 1 })).toHaveText(copied(other))
      await other.seesWeight(rightEye, rightWheel, 0.3)
      await other.seesWeight(leftEye, leftWheel, 0)

      await child.opensHome()
      await link(child, child.word('home.continue', { name: copied(child) })).click()
      await child.seesWeight(rightEye, rightWheel, 0.3)
      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.seesWeight(rightEye, rightWheel, 0)
    })

    test('"load the newer one" puts mine aside, where home shows it', async ({ child, context }) => {
      await child.opensLab('friendship')
      const other = await secondTab(context, language, true)
      await savesInBoth(child, other)
      await other.presses('lab.loadNewer')
      await other.seesWeight(leftEye, leftWheel, 0.5)
      await other.seesWeight(rightEye, rightWheel, 0)

      await child.opensHome()
      await link(child, copied(child)).click()
      await child.seesWeight(rightEye, rightWheel, 0.3)
      await child.seesWeight(leftEye, leftWheel, 0)
    })
  })
}
