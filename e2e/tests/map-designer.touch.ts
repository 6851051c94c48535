// Rooms: map-designer, q-learning
import type { Locator } from '@playwright/test'
import { MapMaker } from '../child-maps.ts'
import type { Spot } from '../hand.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const tap = (thing: Locator) => thing.tap()

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`by finger alone, in ${language}`, () => {
    test.use({ language })

    test('a map is made, with a bend, a sign and a reward, learned and driven', async ({ child, page }) => {
      const maker = new MapMaker(child)
      const touches = ({ x, y }: Spot) => page.touchscreen.tap(x, y)
      await maker.begins(tap)
      const places = [await maker.place(0.15, 0.7), await maker.place(0.5, 0.2), await maker.place(0.85, 0.7)]
      for (const place of places) await touches(place)
      await maker.takes('road', tap)
      for (const [from, to] of [
        [0, 1],
        [1, 2],
        [0, 2],
      ] as const)
        await child.drags(places[from]!, places[to]!)
      await maker.seesReached(1)
      await touches(places[2]!)
      await child.button('design.goalHere').tap()
      await maker.seesReached(2, 1)

      // The straight road gets a bend, too tight at first.
      const middle = await maker.place(0.5, 0.7)
      const [tight, wide] = [await maker.place(0.12, 0.57), await maker.place(0.5, 0.85)]
      await child.drags(middle, tight)
      const fault = page.getByText(child.word('design.fault.tight'))
      await expect(fault).toBeVisible()
      await child.drags(tight, wide)
      await expect(fault).toHaveCount(0)
      await maker.seesTried(3, 3)

      await maker.takes('sign', tap)
      await touches(await maker.place(0.5, 0.78))
      await maker.seesReached(2)
      await maker.takes('reward', tap)
      await touches(places[1]!)
      const stars = page.getByRole('spinbutton', { name: child.word('design.reward'), exact: true })
      await stars.tap()
      await stars.fill('5')
      await stars.blur()
      await maker.learnsAndDrives(tap, 0, 1, 2)
    })
  })
}
