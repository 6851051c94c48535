// Rooms: scripts, service-worker
// By address: the subject is a web space's answer to an address.
import { buildStaticWhenNeeded, webSpace } from '../../scripts/prepare/build.mjs'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { isKept, setsDrivesAndSaves } from '../child-offline.ts'
import { ProjectList } from '../child-projects.ts'
import { expect, test as base } from '../house.ts'
import { serveFolder, type WebSpace } from '../web-space.ts'
import { languagesOf } from '../words.ts'

const operator =
  '# Unsere Schule\n\nFrag **Frau Lee**: [schreib ihr](mailto:lee@school.example) <script>alert(1)</script>'

/** `npm run build:static`, in a folder of a plain web space. */
const test = base.extend<object, { space: WebSpace }>({
  space: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      await buildStaticWhenNeeded()
      const space = await serveFolder(webSpace, '/schools/one/', { 'operator.md': operator })
      await use(space)
      await space.close()
    },
    { scope: 'worker', timeout: 300_000 },
  ],
  house: [async ({ space }, use) => use(new URL(space.url).origin), { scope: 'worker' }],
})
// One build, one worker.
test.describe.configure({ mode: 'default' })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`files in a folder of a web space, in ${language}`, () => {
    test.use({ language })

    test('the lab opens from home, drives, keeps and loads again; nothing outside of the folder is asked for', async ({
      child,
      page,
      space,
    }) => {
      const before = space.outside.length
      await page.goto(space.url)
      await child.seesTitle()
      await child.opensLab('friendship')
      await setsDrivesAndSaves(child)
      await child.reloads()
      await child.seesWeight(leftEye, leftWheel, 0.8)
      expect(page.url()).toContain('/schools/one/lab/friendship')

      await child.presses('lab.menu')
      await child.presses('parts.share')
      const link = await new ProjectList(child).link()
      expect(link).toContain('/schools/one/open')
      await child.presses('parts.close')
      await child.presses('lab.menu')
      await page.getByRole('link', { name: child.word('parts.myProjects') }).click()
      const list = new ProjectList(child)
      await list.seesNames(child.card('friendship'))
      await page.reload()
      await list.seesNames(child.card('friendship'))
      await page.goto(link)
      await child.seesLab()
      await child.seesWeight(rightEye, rightWheel, 0.8)
      expect(space.outside.slice(before)).toEqual([])
    })

    test('the page about shows what lies beside as operator.md, and no HTML of it', async ({
      child,
      page,
      space,
    }) => {
      await page.goto(`${space.url}about/`)
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.word('parts.about'))
      await expect(page.getByRole('heading', { name: 'Unsere Schule' })).toBeVisible()
      await expect(page.getByRole('link', { name: 'schreib ihr' })).toHaveAttribute(
        'href',
        'mailto:lee@school.example',
      )
      await expect.poll(() => page.locator('main script').count()).toBe(0)
      await page.getByRole('link', { name: 'Apache License 2.0' }).click()
      await expect(page.locator('body')).toContainText('Apache License')
    })
  })

  test.describe(`files in a folder of a web space that are kept for offline use, in ${language}`, () => {
    test.use({ language, serviceWorkers: 'allow' })

    test('starts with the cable pulled after one visit', async ({ page, space, context }) => {
      const child = new Child(page, language)
      await page.goto(space.url)
      await isKept(page)
      await context.setOffline(true)
      await page.goto(`${space.url}lab/fear?tried`)
      await child.seesLab()
      expect(page.url()).toContain('/schools/one/lab/fear/?')
      await child.typesWeight(leftEye, rightWheel, 0.5)
      await child.pressesStart()
      await child.seesDriving()
    })
  })
}
