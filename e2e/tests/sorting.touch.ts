// Rooms: sorting
import { SortingHands } from '../child-sorting.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`sorting with a finger in ${language}`, () => {
    test.use({ language, motion: true })

    test('a thing is tapped, a flag pulled, and all is sorted', async ({ child }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      await sorting.thing('cup', 5).tap()
      await expect(sorting.thing('cup', 5)).toHaveAttribute('aria-pressed', 'true')
      const before = await sorting.places()
      await child.drags(await child.middleOf(sorting.flag(1)), await sorting.middleOfPlane())
      await expect.poll(async () => (await sorting.places())[0]).not.toBe(before[0])
      // A flag that stands on a thing leaves it to the finger.
      const [cup, glass] = [sorting.thing('cup', 5), sorting.thing('glass', 9)]
      await child.drags(await child.middleOf(sorting.flag(1)), await child.middleOf(glass))
      await glass.tap()
      await expect(glass).toHaveAttribute('aria-pressed', 'true')
      await expect(cup).toHaveAttribute('aria-pressed', 'false')
      await sorting.presses('play')
      await sorting.seesDone()
    })

    test('points are set with a finger', async ({ child, page }) => {
      const sorting = new SortingHands(child)
      await sorting.opens('points')
      await page.getByRole('combobox').first().selectOption('')
      await page.getByRole('button', { name: sorting.word('tool.add') }).tap()
      const { x, y } = await sorting.middleOfPlane()
      await page.touchscreen.tap(x - 100, y)
      await page.touchscreen.tap(x + 100, y)
      await sorting.seesPoints(2)
    })
  })
}
