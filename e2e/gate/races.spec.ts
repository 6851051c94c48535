import { racesFour } from '../child-racing.ts'
import { expect, follows, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'learners race on the cliff: the criterion is chosen first, and the bill names who wins',
  {
    tag: ['@races', '@/race'],
  },
  async ({ child, page }) => {
    await follows(child, 'home.race')
    const start = child.button('race.start')
    await expect(start).toHaveAttribute('aria-disabled', 'true')
    await page.getByRole('radio', { name: child.word('race.criterion.falls') }).check()
    await start.click()
    const bill = page.getByRole('table').first()
    await expect(bill.getByRole('row')).toHaveCount(5)
    await expect(bill.getByRole('row').nth(1)).toContainText(child.word('race.wins'))
    const timeline = page.getByRole('slider', { name: child.word('race.timeline') })
    await expect(timeline).toHaveValue('99')
    await timeline.press('Home')
    await expect(page.getByText(child.word('race.afterTry', { count: 1 }), { exact: true })).toBeVisible()
  },
)

test(
  'a child walks the railway blind, and Bo goes on with what it has walked',
  {
    tag: ['@races', '@/race'],
  },
  async ({ child, page }) => {
    await page.goto('/race?map=railway&you')
    const through = (room: number) =>
      page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) }).click()
    for (const round of [1, 2, 3]) {
      await expect(page.getByText(child.word('race.tryOf', { now: round, count: 3 }))).toBeVisible()
      for (const room of [5, 0, 1]) await through(room)
      if (round < 3) await child.presses('race.nextTry', { number: round + 1 })
    }
    await expect(page.getByText(child.word('race.mineBest', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
    await child.presses('race.letGoOn', { count: 20 })
    await expect(page.getByText(child.word('race.boWay', { way: '3 → 5 → 0 → 1' }))).toBeVisible()
  },
)

test(
  'four brains race in the garden, and the bill has what each has driven',
  {
    tag: ['@races', '@/race'],
  },
  async ({ child, page }) => {
    await page.goto('/race?brains=garden')
    await expect(child.button('race.brains.startSealed', { number: 3 })).toBeVisible()
    await racesFour(child)
    // As `botgarten race four-brains --course garden` says.
    await expect(page.getByRole('table').getByRole('row').nth(1)).toContainText('862')
  },
)
