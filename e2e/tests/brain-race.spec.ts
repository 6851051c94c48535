// Rooms: races, experiments
import { readFile } from 'node:fs/promises'
import { racesFour } from '../child-racing.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'

test('four brains race in the garden by keys: starts open, the bill is read and taken along', async ({
  child,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await opensFromHome(child, 'home.race')
  await page.getByRole('link', { name: child.word('race.brains.title'), exact: true }).click()
  await expect(child.button('race.brains.startSealed', { number: 3 })).toBeVisible()
  await racesFour(child)
  // The figures of the command line.
  const rows = page.getByRole('table').getByRole('row')
  await expect(rows.nth(1)).toContainText('862')
  await expect(rows.nth(1)).toContainText('896')
  await child.button('race.brains.startNumber', { number: 4 }).focus()
  await page.keyboard.press('Enter')
  await expect(child.button('race.brains.startNumber', { number: 4 })).toHaveAttribute('aria-pressed', 'true')
  const moment = page.getByRole('slider', { name: child.word('race.brains.moment') })
  await expect(moment).toHaveValue('600')
  await moment.focus()
  await page.keyboard.press('Home')
  await expect(page.getByText(child.word('race.brains.second', { second: 0, of: 60 }))).toBeVisible()
  await page.getByRole('radio').first().check()
  const [download] = await Promise.all([page.waitForEvent('download'), child.presses('race.brains.csv')])
  expect((await readFile(await download.path(), 'utf8')).trim().split('\n')).toHaveLength(15)
})
