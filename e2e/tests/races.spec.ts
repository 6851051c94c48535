// Rooms: races, q-learning
import { mapField } from '@botgarten/blocks'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'

test('four learners race on the cliff, by keys, and their curve is a table too', async ({ child, page }) => {
  await opensFromHome(child, 'home.race')
  await expect(child.button('race.start')).toHaveAttribute('aria-disabled', 'true')
  await page.getByRole('radio', { name: child.word('race.criterion.falls') }).focus()
  await page.keyboard.press('Space')
  await child.button('race.start').focus()
  await page.keyboard.press('Enter')
  const bill = page.getByRole('table').first()
  await expect(bill.getByRole('row')).toHaveCount(5)
  await expect(bill.getByRole('row').nth(1)).toContainText(child.word('race.wins'))
  await expect(page.getByText(child.word('race.whyOther'))).toBeVisible()
  const timeline = page.getByRole('slider', { name: child.word('race.timeline') })
  await expect(timeline).toHaveValue('99')
  await timeline.focus()
  await page.keyboard.press('Home')
  await expect(page.getByText(child.word('race.afterTry', { count: 1 }), { exact: true })).toBeVisible()
  await page.keyboard.press('End')
  await child.button('race.table').focus()
  await page.keyboard.press('Enter')
  await expect(page.getByRole('table').nth(1).getByRole('row')).toHaveCount(12)
})

test.describe('with a finger', () => {
  test.use({ hasTouch: true })

  test('a child walks the railway blind, sees both tables, and races with what it walked', async ({
    child,
    page,
  }) => {
    await opensFromHome(child, 'home.race')
    await child.button('race.map').tap()
    const railway = child.word(`choice.${mapField('railway')}`)
    await page.getByRole('dialog').getByRole('button', { name: railway, exact: true }).tap()
    await child.button('race.toYou').tap()
    const through = (room: number) =>
      page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) }).tap()
    for (const round of [1, 2, 3]) {
      await expect(page.getByText(child.word('race.tryOf', { now: round, count: 3 }))).toBeVisible()
      await through(5)
      await page.getByRole('button', { name: child.word('race.stars', { count: round }), exact: true }).tap()
      await through(0)
      await through(1)
    }
    await expect(page.getByText(child.word('race.mineBest', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
    await page.getByLabel(child.word('race.whatDid')).fill('5 → 0')
    await child.button('race.letGoOn', { count: 20 }).tap()
    await expect(page.getByText(child.word('race.boWay', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
    await child.button('race.raceWithMe').tap()
    await page.getByText(child.word('race.criterion.way')).tap()
    await child.button('race.start').tap()
    await expect(page.getByRole('table').first().getByRole('row')).toHaveCount(6)
    await expect(page.getByRole('row', { name: child.word('race.racer.me') })).toContainText(
      child.word('race.wins'),
    )
  })
})
