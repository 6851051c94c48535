// Rooms: training
import { Teaching } from '../child-training.ts'
import { finger } from '../hand.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`by finger alone, in ${language}`, () => {
    test.use({ language })

    test('a child sets the pad, remembers, drives, and drags along the curve', async ({ child, page }) => {
      const teaching = new Teaching(child)
      await child.opensLab('show-it')
      await teaching.shows()
      const hand = finger(page)
      const push = async (act: () => Promise<void>) => {
        const { x, y, width } = (await teaching.pad.boundingBox())!
        const middle = { x: x + width / 2, y: y + width / 2 }
        await hand.down(middle)
        await hand.move({ x: middle.x + width * 0.06, y: middle.y - width * 0.2 })
        await act()
        await hand.up()
      }
      const left = page.getByRole('slider', { name: child.word('training.leftWheel'), exact: true })
      await push(async () => expect.poll(async () => Number(await left.inputValue())).toBeGreaterThan(40))
      await page.locator('.hand .main').getByRole('button').tap()
      await teaching.seesExamples(1)

      await teaching.chooses('drive')
      await push(() => expect.poll(() => teaching.count()).toBeGreaterThan(6))
      const driven = await teaching.count()

      await teaching.letsPractise()
      await teaching.practises()
      const { x, y, width, height } = (await teaching.curve.boundingBox())!
      await page.touchscreen.tap(x + 0.4 * width, y + height / 2)
      await expect(teaching.curve).not.toHaveAttribute('aria-valuenow', '60')
      await teaching.shows()
      await teaching.seesExamples(driven)
    })
  })
