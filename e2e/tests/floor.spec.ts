// Rooms: world
import { leftEye, leftWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const pixels = /\.pixels$/

for (const language of languagesOf(import.meta.filename))
  test.describe(`a floor whose picture does not load, in ${language}`, () => {
    test.use({ language, complaints: [/Failed to load resource/] })

    test('is shown as a message, and Start is refused until it can be read', async ({ child, page }) => {
      await page.route(pixels, (route) => route.abort())
      await child.opensLab('friendship')
      const note = page.getByRole('status').filter({ hasText: child.word('session.floorMissing') })
      await expect(note).toBeVisible()
      await child.typesWeight(leftEye, leftWheel, 0.8)
      await child.presses('parts.close')
      await expect(note).toHaveCount(0)
      await child.presses('lab.start')
      await expect(note).toBeVisible()
      await expect(child.button('lab.start').first()).toBeVisible()

      await page.unroute(pixels)
      await child.pressesStart()
      await child.seesDriving()
      await expect(note).toHaveCount(0)
    })
  })
