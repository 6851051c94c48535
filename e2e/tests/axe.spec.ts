import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { leftEye, leftWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languages } from '../words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 390, height: 844 },
]

/** What axe finds, a line each: the rule and where. */
async function findings(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze()
  return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target.join(' ')}`))
}

const screens: { readonly [name: string]: (child: Child) => Promise<void> } = {
  'the home page': (child) => child.opensHome(),
  'a card': (child) => child.opensLab('friendship'),
  'a card while it runs': async (child) => {
    await child.opensLab('friendship')
    await child.pressesStart()
  },
  'a card laid open': async (child) => {
    await child.opensLab('fear')
    await child.presses('lab.card')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'a hint': async (child) => {
    await child.opensLab('fear')
    await child.presses('lab.hint')
    await expect(child.page.getByText(child.word('lab.hintTitle', { number: 1, of: 3 }))).toBeVisible()
  },
  'the free lab': (child) => child.opensLab('free'),
  'my projects': async (child) => {
    await child.opensLab('friendship')
    await child.typesWeight(leftEye, leftWheel, 0.4)
    await child.seesSaved()
    await child.page.goto('/projects')
    await expect(child.page.getByRole('article').first()).toBeVisible()
    const name = child.word('home.friendship')
    await child.presses('projects.more', { name })
  },
  'a project as a link': async (child) => {
    await child.presses('parts.share')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'the bin': async (child) => {
    await child.page.goto('/projects/bin')
    await expect(child.words('projects.binEmpty')).toBeVisible()
  },
  'the page about': async (child) => {
    await child.page.goto('/about')
    await child.seesTitle()
  },
  'a card that is not there': async (child) => {
    await child.page.goto('/lab/nothing')
    await expect(child.page.getByText(child.word('lab.unknownCardTitle'))).toBeVisible()
  },
}

for (const language of languages) {
  test.describe(`in ${language}`, () => {
    // The browser notes the answer 404 to the card that is not there.
    test.use({ language, complaints: [/404/] })

    for (const viewport of sizes) {
      test(`axe finds nothing at ${viewport.width} × ${viewport.height}`, async ({ child, page }) => {
        test.setTimeout(180_000)
        await page.setViewportSize(viewport)
        // Half-faded words of a dialog that opens have half their contrast.
        await page.emulateMedia({ reducedMotion: 'reduce' })
        const found: { [screen: string]: string[] } = {}
        for (const [screen, show] of Object.entries(screens)) {
          await show(child)
          found[screen] = await findings(page)
        }
        expect(found).toEqual(Object.fromEntries(Object.keys(screens).map((screen) => [screen, []])))
      })
    }
  })
}
