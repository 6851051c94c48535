import { mapField } from '@botgarten/blocks'
import { content } from '@botgarten/content/files'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { settingsOf, variantsOf } from '../variant.ts'

/** From home to the race, and to its map of this name. */
async function opensRace(child: Child, map: string) {
  await opensFromHome(child, 'home.race')
  await child.presses('race.map')
  const name = child.word(`choice.${mapField(map)}`)
  await child.press(child.page.getByRole('dialog').getByRole('button', { name, exact: true }))
  await expect(child.page).toHaveURL(new RegExp(`map=${map}$`))
}

for (const { map, variant } of content.maps.flatMap((map) =>
  variantsOf(`race ${map}`).map((variant) => ({ map, variant })),
)) {
  test.describe(`the race on the map ${map} in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

    test('is run to its end, with what each one needed and the curves of all', async ({ child, page }) => {
      await opensRace(child, map)
      // The criteria differ from map to map.
      await child.press(page.getByRole('radio').first())
      await child.presses('race.start')
      const bill = page.getByRole('table').first()
      await expect(bill.getByRole('row')).toHaveCount(5, { timeout: 120_000 })
      // Without a good way there is no winner.
      const wins = bill.getByText(child.word('race.wins'))
      await expect(wins.or(child.words('race.noWinner')).first()).toBeAttached()
      await child.presses('race.table')
      await expect(page.getByRole('table').nth(1).getByRole('row')).toHaveCount(12)
    })
  })
}

for (const variant of variantsOf('you against Bo'))
  test.describe(`you against Bo in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

    test('a child walks the railway blind three times, Bo goes on from its table, and both race', async ({
      child,
      page,
    }) => {
      await opensRace(child, 'railway')
      await child.presses('race.toYou')
      const through = (room: number) =>
        child.press(page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) }))
      for (const round of [1, 2, 3]) {
        await expect(page.getByText(child.word('race.tryOf', { now: round, count: 3 }))).toBeVisible()
        await through(5)
        await child.presses('race.stars', { count: round })
        await through(0)
        await through(1)
        if (round < 3) await child.presses('race.nextTry', { number: round + 1 })
      }
      await expect(page.getByText(child.word('race.mineBest', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
      await child.presses('race.letGoOn', { count: 20 })
      await expect(page.getByText(child.word('race.boWay', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
      await child.presses('race.raceWithMe')
      await child.press(page.getByText(child.word('race.criterion.way'), { exact: true }))
      await child.presses('race.start')
      const bill = page.getByRole('table').first()
      await expect(bill.getByRole('row')).toHaveCount(6)
      await expect(page.getByRole('row', { name: child.word('race.racer.me') })).toContainText(
        child.word('race.wins'),
      )
    })
  })
