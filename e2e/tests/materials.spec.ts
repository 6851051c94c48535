// Rooms: materials
// By address: codes on paper and links of a plan lead to a page of its own.
import { content } from '@botgarten/content/files'
import { sample } from '@botgarten/numbers/testing'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { languagesOf } from '../words.ts'

const { items } = content
/** Items, and each card that is none by itself. */
const offered =
  items.length + content.cards.filter(({ code }) => items.every((item) => item.code !== code)).length
const kinds = [...new Set(items.map(({ kind }) => kind))]
const ready = '.material[aria-busy="false"]'

test('the page of every item and of all questions is the same file: one is kept for all', async ({
  house,
}) => {
  const places = [...items.map(({ kind, id }) => `${kind}/${id}`), 'questions/1', 'questions/4']
  const pages = await Promise.all(
    places.map(async (place) => {
      const answer = await fetch(`${house}/materials/${place}`)
      return answer.ok ? answer.text() : `${place}: ${answer.status}`
    }),
  )
  expect(new Set(pages).size).toBe(1)
})

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`learning materials, in ${language}`, () => {
    test.use({ language })

    for (const kind of kinds)
      test(`items of the kind ${kind} are drawn whole`, async ({ page }) => {
        const wrong: string[] = []
        const ofKind = items.filter((item) => item.kind === kind)
        for (const { id } of sample(ofKind, 1)) {
          await page.goto(`/materials/${kind}/${id}`)
          await expect(page.locator(ready)).toBeVisible()
          await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1)
          const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
          if (wider > 0) wrong.push(`${id} is ${wider} px wider than the screen`)
          const cut = await page
            .locator('.slide .face')
            .evaluateAll((faces) =>
              faces.flatMap((face, at) =>
                face.scrollHeight > face.clientHeight || face.scrollWidth > face.clientWidth ? [at + 1] : [],
              ),
            )
          if (cut.length > 0) wrong.push(`${id}: slides ${cut.join(', ')} do not fit`)
        }
        expect(wrong).toEqual([])
      })

    test('the library finds by grade, way and words, and a tile opens its item', async ({ child, page }) => {
      await opensFromHome(child, 'home.materials')
      const count = page.locator('.library').getByRole('status')
      const told = (some: number) => child.word('materials.fit', { count: some, of: offered })
      await expect(count).toHaveText(told(offered))
      await page.getByRole('checkbox', { name: child.word('materials.wayName.reinforcement') }).check()
      await expect(count).not.toHaveText(told(offered))
      const tiles = page.locator('.library li')
      await page.getByRole('searchbox').fill('Q1')
      await expect(tiles.first().getByRole('heading')).toHaveText(child.card('railway'))
      await page.getByRole('heading', { level: 2, name: child.card('railway') }).click()
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.card('railway'))
      await page.goBack()
      await expect(page.getByRole('searchbox')).toHaveValue('Q1')
      await page.reload()
      await expect(tiles.first().getByRole('heading')).toHaveText(child.card('railway'))
      await page.getByRole('checkbox', { name: child.word('materials.shelf.more') }).check()
      await expect(page.locator('.library li')).toHaveCount(0)
      await child.tabsAndPresses('materials.takeAway')
      await expect(count).toHaveText(told(offered))
      await expect(page.getByRole('searchbox')).toBeFocused()
      await page.goto('/materials?module=3&kind=slides')
      await expect(page.locator('.library li')).toHaveCount(3)
      await expect.poll(() => page.locator('.library input:checked').count()).toBe(3)
    })

    test('slides are turned by keys, and the teacher sees what comes next in another window', async ({
      child,
      page,
      context,
    }) => {
      await page.goto('/materials/slides/teach-your-robot')
      await expect(page.locator(ready)).toBeVisible()
      await child.tabsAndPresses('materials.present')
      const at = (number: number) => page.getByText(child.word('materials.slideOf', { number, of: 19 }))
      await expect(at(1)).toBeVisible()
      await child.types('ArrowRight', ' ', 'PageDown')
      await expect(at(4)).toBeVisible()
      await child.types('ArrowLeft')
      await expect(at(3)).toBeVisible()
      const [presenter] = await Promise.all([
        context.waitForEvent('page'),
        child.presses('materials.presenter'),
      ])
      await expect(presenter.getByRole('heading', { name: child.word('materials.comes') })).toBeVisible()
      await expect(presenter.getByText(child.word('materials.slideOf', { number: 3, of: 19 }))).toBeVisible()
      await presenter.keyboard.press('End')
      await expect(at(19)).toBeVisible()
      await page.bringToFront()
      await child.types('Home', 'Escape')
      await expect(child.button('materials.present')).toBeVisible()
    })

    test('on a slide the lab itself drives, and what a child has kept stays as it is', async ({
      child,
      page,
    }) => {
      await page.goto('/materials/slides/how-does-your-robot-learn?slide=7')
      const lab = page.frameLocator('iframe')
      await lab
        .getByRole('button', { name: child.word('lab.start'), exact: true })
        .first()
        .click()
      await expect(
        lab.getByRole('button', { name: child.word('lab.stop'), exact: true }).first(),
      ).toBeVisible()
      // A slide fills the window, without a link home.
      await page.goto('/')
      await child.opensLab('fear')
      const weights = await child.knobs.evaluateAll((all) => all.map((one) => one.ariaValueNow))
      expect(new Set(weights)).toEqual(new Set(['0']))
    })

    test('a question is answered by keys, says why, and is remembered', async ({ child, page }) => {
      await page.goto('/materials/questions/1')
      await expect(page.locator(ready)).toBeVisible()
      const first = page.getByRole('group').locator('..').locator('.answers button').first()
      await child.tabsTo(first)
      await child.types('Enter')
      const why = page.locator('.why')
      await expect(why).not.toBeEmpty()
      await page.reload()
      await child.presses('materials.before')
      await expect(why).not.toBeEmpty()
    })
  })
}
