// Rooms: inside
import { Asker } from '../child-inside.ts'
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('holds Bo, taps on the trail, and sees why it was so then', async ({ child, page }) => {
      const asker = new Asker(child)
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.7)
      await child.typesWeight(leftEye, rightWheel, 0.6)
      await child.pressesStart()
      const start = await child.middleOf(child.bo)
      await child.seesDriving()
      await child.watches(90)
      await child.presses('lab.pause')
      await expect(page.locator('polyline.tap')).toHaveCount(1)
      const trail = await page.locator('polyline.tap').evaluate((line: SVGPolylineElement) => {
        const point = line.points.getItem(Math.floor(line.points.numberOfItems / 2))
        const box = line.ownerSVGElement!.getBoundingClientRect()
        return { x: box.left + point.x, y: box.top + point.y }
      })
      expect(trail).not.toEqual(start)
      await page.touchscreen.tap(trail.x, trail.y)
      await expect(child.button('time.goOn')).toBeVisible()
      await asker.seesAnswer()
      await asker.seesSharesAddUp()
      await asker.eye('frontLeft').tap()
      await expect(asker.eye('frontLeft')).toHaveAttribute('aria-pressed', 'true')
    })
  })
}
