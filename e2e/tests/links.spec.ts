// Rooms: share
// By address: the subject is links.
import type { Block } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import { reads } from '../camera.ts'
import { Child, leftEye, leftWheel } from '../child.ts'
import { ProjectList } from '../child-projects.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** A text of a project that does not become smaller by compressing. */
function noise(length: number): string {
  let seed = 1
  return Array.from({ length }, () => (seed = (seed * 48271) % 2147483647) % 10).join('')
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a project as a link, in ${language}`, () => {
    test.use({ language })

    /** Sets a weight and takes the link from the lab's menu. */
    async function sharesFromLab(child: Child): Promise<string> {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.45)
      await child.seesSaved()
      await child.presses('lab.menu')
      await child.presses('parts.share')
      return new ProjectList(child).link()
    }

    test('whoever opens it has a project of their own; mine stays as it is', async ({ child, browser }) => {
      const link = await sharesFromLab(child)
      expect(link.length).toBeLessThan(11_100)
      const context = await browser.newContext({ locale: language })
      const friend = new Child(await context.newPage(), language)
      await friend.page.goto(link)
      await friend.seesLab()
      await expect(friend.page).not.toHaveURL(/#/)
      await friend.seesWeight(leftEye, leftWheel, 0.45)
      await friend.typesWeight(leftEye, leftWheel, 0.8)
      await friend.seesSaved()
      await friend.reloads()
      await friend.seesWeight(leftEye, leftWheel, 0.8)
      await context.close()
      await child.reloads()
      await child.seesWeight(leftEye, leftWheel, 0.45)
    })

    test('the copied link is the one that is shown, and its code leads there', async ({ child, context }) => {
      await context.grantPermissions(['clipboard-read', 'clipboard-write'])
      const link = await sharesFromLab(child)
      await child.presses('share.copy')
      await expect(child.words('share.copied')).toBeVisible()
      await expect.poll(() => child.page.evaluate(() => navigator.clipboard.readText())).toBe(link)
      await expect
        .poll(() => reads(child.page.getByRole('img', { name: child.word('share.code') })))
        .toBe(link)
    })

    test('without the clipboard of secure pages it is copied all the same', async ({ child, page }) => {
      await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }))
      await sharesFromLab(child)
      await child.presses('share.copy')
      await expect(child.words('share.copied')).toBeVisible()
    })

    test('where nothing can be copied the link is chosen, and the way said', async ({ child, page }) => {
      await page.addInitScript(() => {
        Object.defineProperty(navigator, 'clipboard', { value: undefined })
        Object.defineProperty(document, 'execCommand', { value: () => false })
      })
      const link = await sharesFromLab(child)
      await child.presses('share.copy')
      await expect(child.words('share.byHand')).toBeVisible()
      await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe(link)
    })

    test('a broken link is refused with a reason, and nothing here changes', async ({ child, page }) => {
      const link = await sharesFromLab(child)
      const [address, hash] = link.split('#') as [string, string]
      const refused = [
        ['cut in half', link.slice(0, link.length / 2), 'linkCut'],
        ['of a later version', '2.abc.def', 'linkNewer'],
        ['without anything', '', 'linkCut'],
        ['that is too long', link + 'A'.repeat(12_000), 'linkTooBig'],
      ] as const
      for (const [what, broken, problem] of refused)
        await test.step(what, async () => {
          await page.goto(`${address}#${broken}`)
          await page.reload()
          await expect(page.getByRole('heading', { level: 1 })).toHaveText(
            child.word(`problem.${problem}.title`),
          )
          await expect(child.words(`problem.${problem}.text`)).toBeVisible()
        })
      // The whole link, pasted over the broken one, opens; of the others nothing is there.
      await page.evaluate((whole) => (location.hash = whole), hash)
      await child.seesLab()
      await child.seesWeight(leftEye, leftWheel, 0.45)
      const list = new ProjectList(child)
      await list.opens()
      await expect.poll(() => list.names()).toHaveLength(2)
    })

    test('a project that is too large for a link offers the file', async ({ child, page }) => {
      const list = new ProjectList(child)
      await list.opens()
      const file = JSON.parse(freeProgram('Riesig', (make) => [make.wait(1)])) as Project
      const data = noise(15_000)
      const blocks = file.programs['main']!.stacks[0]!.blocks as Block[]
      blocks.push(
        { id: 'n1', type: 'text', data },
        { id: 'n2', type: 'text', data: data.split('').reverse().join('') },
      )
      await list.opensFile('riesig.json', JSON.stringify(file))
      await expect(page.getByRole('heading', { level: 1 })).toHaveText('Riesig')
      await list.opens()
      await list.chooses('Riesig', 'share')
      await expect(child.dialog('share.tooLargeTitle')).toContainText(child.word('share.tooLargeText'))
      await Promise.all([
        page.waitForEvent('download'),
        child
          .dialog('share.tooLargeTitle')
          .getByRole('button', { name: child.word('projects.saveFile') })
          .click(),
      ])
    })
  })
}
