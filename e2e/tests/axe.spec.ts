// Rooms: parts, projects, about, share
import { axeFindings } from '../axe.ts'
import { ProjectList } from '../child-projects.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { languagesOf } from '../words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 390, height: 844 },
]

/** The pages about projects and the one about Botgarten; axe-home.spec.ts visits home. */
const screens: { readonly [name: string]: (child: Child) => Promise<void> } = {
  'my projects': async (child) => {
    await child.opensLab('friendship')
    await child.presses('lab.hint')
    await child.seesSaved()
    await new ProjectList(child).opens()
    await expect(child.page.getByRole('article').first()).toBeVisible()
    const name = child.card('friendship')
    await child.presses('projects.more', { name })
  },
  'a project as a link': async (child) => {
    await child.presses('parts.share')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'the bin': async (child) => {
    await child.types('Escape')
    await new ProjectList(child).goesToBin()
    await expect(child.words('projects.binEmpty')).toBeVisible()
  },
  'the page about': async (child) => {
    await opensFromHome(child, 'parts.about')
    await expect(child.page.getByRole('heading', { level: 1 })).toHaveText(child.word('parts.about'))
  },
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language })

    for (const viewport of sizes) {
      test(`axe finds nothing at ${viewport.width} × ${viewport.height}`, async ({ child, page }) => {
        await page.setViewportSize(viewport)
        // Half-faded words of a dialog that opens have half their contrast.
        await page.emulateMedia({ reducedMotion: 'reduce' })
        const found: { [screen: string]: string[] } = {}
        for (const [screen, show] of Object.entries(screens)) {
          await show(child)
          found[screen] = await axeFindings(page)
        }
        expect(found).toEqual(Object.fromEntries(Object.keys(screens).map((screen) => [screen, []])))
      })
    }
  })
}
