// Rooms: races, q-learning
import { mapField } from '@botgarten/blocks'
import type { Page } from '@playwright/test'
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
      if (round < 3) await child.button('race.nextTry', { number: round + 1 }).tap()
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

test('a child who walks blind by keys keeps the focus from door to door and from try to try', async ({
  child,
  page,
}) => {
  await opensFromHome(child, 'home.race')
  await child.presses('race.map')
  const railway = child.word(`choice.${mapField('railway')}`)
  await child.press(page.getByRole('dialog').getByRole('button', { name: railway, exact: true }))
  await child.presses('race.toYou')
  const door = (room: number) =>
    page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')} ${room} `) })
  await door(5).focus()
  await child.types('Enter')
  const anyDoor = page.locator('.room button:focus')
  await expect(anyDoor).toHaveCount(1)
  await child.tabsTo(door(0))
  await child.types('Enter')
  await expect(anyDoor).toHaveCount(1)
  await child.tabsTo(door(1))
  await child.types('Enter')
  await expect(child.button('race.nextTry', { number: 2 })).toBeFocused()
  await child.types('Enter')
  await expect(anyDoor).toHaveCount(1)
})

for (const [width, height] of [
  [1366, 768],
  [1024, 768],
] as const)
  test.describe(`at ${width}x${height} in German`, () => {
    test.use({ language: 'de', viewport: { width, height } })

    test('the bill of four learners and the labels of their curves are whole', async ({ child, page }) => {
      await opensFromHome(child, 'home.race')
      await page.getByText(child.word('race.criterion.stars')).click()
      await page.getByRole('combobox', { name: child.word('race.runs') }).selectOption('5')
      await child.presses('race.start')
      const bill = page.locator('.bill .table')
      await expect(bill.getByRole('row')).toHaveCount(5)
      await expect(page.getByText(child.word('race.text'))).toHaveCount(0)
      const cut = () =>
        page.evaluate(() => {
          const table = document.querySelector('.bill .table')!
          const paper = document.querySelector('.curves .paper')!.getBoundingClientRect()
          const labels = [...document.querySelectorAll('.curves .paper text')].filter((label) => {
            const { left, right } = label.getBoundingClientRect()
            return left < paper.left || right > paper.right
          })
          const bar = document.querySelector('.race > .bar')!.getBoundingClientRect()
          return [
            Math.max(0, Math.round(paper.bottom - bar.top)),
            table.scrollHeight - table.clientHeight,
            table.scrollWidth - table.clientWidth,
            ...labels.map((label) => label.textContent),
          ]
        })
      await expect.poll(cut).toEqual([0, 0, 0])
      await expect(page.locator('.bill, .curves').getByText(/-\d/)).toHaveCount(0)
    })
  })

/** Options that the closed select is too narrow for. */
const cutOptions = (page: Page) =>
  page.locator('select').evaluateAll((selects) =>
    (selects as HTMLSelectElement[])
      .filter((select) => select.checkVisibility())
      .flatMap((select) => {
        const alone = select.cloneNode() as HTMLSelectElement
        alone.style.cssText = 'position:absolute;width:max-content;min-width:0;max-width:none'
        select.after(alone)
        const cut = [...select.options].filter((option) => {
          alone.replaceChildren(option.cloneNode(true))
          return alone.offsetWidth > select.offsetWidth
        })
        alone.remove()
        return cut.map((option) => `${option.text}: ${select.offsetWidth} px`)
      }),
  )

for (const language of ['de', 'en'] as const)
  for (const [width, height] of [
    [1366, 768],
    [1024, 768],
    [390, 844],
  ] as const)
    test.describe(`at ${width}x${height} in ${language}`, () => {
      test.use({ language, viewport: { width, height } })

      test('every option of every select fits into it', async ({ child, page }) => {
        await opensFromHome(child, 'home.race')
        const learner = page.locator('li > button[aria-expanded]').first()
        await learner.click()
        const kind = page.getByRole('combobox', { name: child.word('race.kind') })
        const kinds = await kind.locator('option').evaluateAll((all) => all.map((one) => one.textContent))
        expect(kinds.length).toBeGreaterThan(3)
        for (const label of kinds) {
          await kind.selectOption({ label })
          expect([label, await cutOptions(page)]).toEqual([label, []])
        }
      })
    })

for (const language of ['de', 'en'] as const)
  for (const width of [1366, 1024])
    test.describe(`a race in ${language} at ${width}x768`, () => {
      test.use({ language, viewport: { width, height: 768 } })

      test('shows the ways of all learners without scrolling', async ({ child, page }) => {
        await opensFromHome(child, 'home.race')
        await page.getByText(child.word('race.criterion.stars')).click()
        await page.getByRole('combobox', { name: child.word('race.runs') }).selectOption('5')
        await child.presses('race.start')
        const ways = page.locator('.ways li')
        await expect(ways).toHaveCount(4)
        await expect(page.getByText(child.word('race.text'))).toHaveCount(0)
        const cut = () => ways.locator('xpath=..').evaluate((list) => list.scrollHeight - list.clientHeight)
        await expect.poll(cut).toBe(0)
      })
    })

test.describe('in a window 683 wide', () => {
  test.use({ viewport: { width: 683, height: 768 } })

  test('the bar is whole, and the ways have a map', async ({ child, page }) => {
    await opensFromHome(child, 'home.race')
    await expect(page.locator('.ways .map')).toBeVisible()
    const width = () =>
      page.locator('.page-bar').evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)
    await expect.poll(width).toBe(0)
    const high = () => page.locator('.ways .map').evaluate((map) => map.getBoundingClientRect().height)
    await expect.poll(high).toBeGreaterThan(120)
  })
})

for (const language of ['de', 'en'] as const)
  test.describe(`a screen reader in ${language}`, () => {
    test.use({ language })

    test('hears doors by their sides in that language, and the notes show the room that Bo is in', async ({
      child,
      page,
    }) => {
      await opensFromHome(child, 'home.race')
      await child.presses('race.toYou')
      const sides = (['left', 'right', 'up', 'down'] as const).map((side) => child.word(`race.sides.${side}`))
      const door = (side: string) =>
        page.getByRole('button', { name: new RegExp(`${child.word('race.door')} ${side} `) })
      // Up from the cliff, and to and fro: its notes grow longer than their box.
      for (const side of [sides[2]!, ...Array.from({ length: 9 }, () => sides[1]!), sides[2]!, sides[2]!])
        await door(side).click()
      const here = page.locator('.notes .here')
      await expect(here).toBeInViewport({ ratio: 0.95 })
      const heard = () =>
        page.evaluate(() =>
          [
            ...[...document.querySelectorAll('[aria-label]')].map((one) => one.getAttribute('aria-label')!),
            ...[...document.querySelectorAll('.for-ears-only, [aria-live]')].map((one) => one.textContent),
          ].join('\n'),
        )
      const foreign = {
        de: /\b(left|right|up|down|room|door|stars?)\b/i,
        en: /\b(nach links|rechts|oben|unten|Raum|Tür|Sterne?)\b/i,
      }
      await expect.poll(heard).not.toMatch(foreign[language])
      await expect.poll(heard).toContain(sides[0]!)
    })
  })
