// Rooms: map-designer, q-learning
import { expect, type Locator } from '@playwright/test'
import { MapMaker } from '../child-maps.ts'
import { test } from '../house.ts'
import { languagesOf } from '../words.ts'

const tap = (thing: Locator) => thing.tap()

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`with a finger, in ${language}`, () => {
    test.use({ language })

    test('a map is made from start to print, and driven', async ({ child }) => {
      const maker = new MapMaker(child)
      await maker.begins(tap)
      await maker.draws(tap)
      await tap(child.button('design.station', { station: 2 }))
      await tap(child.button('design.goalHere'))
      await maker.seesReached(2)
      await maker.seesAllTried()
      await maker.prints(tap)
      await maker.learnsAndDrives(tap, 0, 1, 2)
    })

    test('rooms are made by tapping, and Bo learns in them', async ({ child, page }) => {
      const maker = new MapMaker(child)
      await maker.begins(tap, 'rooms.new')
      const room = (number: number) => page.locator('.field button').nth(number)
      for (const wall of [1, 5, 9]) await tap(room(wall))
      await expect(page.getByText(child.word('rooms.reached', { count: 6 }))).toBeVisible()
      await tap(room(13))
      await expect(page.getByText(child.word('rooms.notReached'))).toBeVisible()
      await tap(child.button('design.undo'))
      await maker.learnsAndDrives(tap, 0, 4, 8, 12, 13, 14, 15)
    })
  })
}
