// Rooms: sorting
import { SortingHands, sortingProject } from '../child-sorting.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`sorting in ${language}`, () => {
    test.use({ language })

    test('the home page leads there; things find their groups, which keep the names of the child', async ({
      child,
      page,
    }) => {
      const sorting = new SortingHands(child)
      await child.opensHome()
      await page.getByRole('link', { name: child.word('home.sorting'), exact: true }).click()
      await expect(sorting.flags).toHaveCount(3)
      await sorting.sorts()
      await sorting.seesDone()
      await sorting.group(1).fill('Bottles')
      await sorting.thing('bottle', 1).click()
      await sorting.hearsDistances(3)
      await child.seesSaved()
      await page.reload()
      // With the groups, not with the flags alone.
      await sorting.seesDone()
      await expect(sorting.group(1)).toHaveValue('Bottles')
    })

    test('a flag is pulled; the way back leads to every step', async ({ child, page }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      await child.drags(await child.middleOf(sorting.flag(1)), await sorting.middleOfPlane())
      const pulled = await sorting.places()
      await sorting.presses('join')
      await sorting.presses('move')
      await expect.poll(() => sorting.places()).not.toEqual(pulled)
      await sorting.presses('back')
      await sorting.presses('back')
      await expect.poll(() => sorting.places()).toEqual(pulled)
      await page.getByRole('slider', { name: sorting.word('wayBack') }).press('End')
      await expect.poll(() => sorting.places()).not.toEqual(pulled)
    })

    test('all of it with the keyboard', async ({ child }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      const before = await sorting.places()
      await child.tabsTo(sorting.flag(2))
      await child.types('ArrowLeft', 'ArrowUp', 'Shift+ArrowUp')
      const after = await sorting.places()
      expect(after[1]).not.toBe(before[1])
      expect(after[0]).toBe(before[0])
      await child.tabsAndPresses('sorting.joinOne')
      await sorting.plane.focus()
      await child.types('ArrowRight')
      await sorting.hearsDistances(3)
      await child.types('Escape')
      await child.tabsAndPresses('sorting.join')
      await child.tabsAndPresses('sorting.moveOne')
      await child.tabsAndPresses('sorting.play')
      await sorting.seesDone()
    })

    test('points by hand, by key and taken away; no more flags than points', async ({ child }) => {
      const sorting = new SortingHands(child)
      await sorting.opens('points')
      await child.page.getByRole('combobox').first().selectOption('')
      await expect(sorting.words('noPoints')).toBeVisible()
      await sorting.presses('tool.add')
      const middle = await sorting.middleOfPlane()
      await child.page.mouse.click(middle.x - 150, middle.y - 100)
      await child.page.mouse.click(middle.x + 150, middle.y + 100)
      await sorting.plane.focus()
      await child.types('ArrowUp', 'ArrowUp', 'Enter')
      await sorting.seesPoints(3)
      await expect(sorting.flags).not.toHaveCount(4)
      await sorting.presses('tool.remove')
      await child.page.mouse.click(middle.x - 150, middle.y - 100)
      await sorting.seesPoints(2)
      const more = child.button('sorting.moreFlags')
      while ((await more.getAttribute('aria-disabled')) !== 'true') await more.click()
      await expect(sorting.flags).toHaveCount(2)
      const fewer = child.button('sorting.fewerFlags')
      while ((await fewer.getAttribute('aria-disabled')) !== 'true') await fewer.click()
      await expect(sorting.flags).toHaveCount(1)
    })

    test('Bo drives, collects and finds the colours', async ({ child, page }) => {
      const sorting = new SortingHands(child)
      await sorting.opens('readings')
      await expect(sorting.words('noReadings')).toBeVisible()
      await sorting.presses('drive.lanes')
      await expect(
        page.getByText(new RegExp(`^[4-9]\\d ${sorting.word('readingCount', { count: '' }).trim()}$`)),
      ).toBeVisible()
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await sorting.presses('tab.things')
      await sorting.presses('tab.readings')
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await sorting.presses('drive.lanes')
      await child.seesSaved()
      await page.reload()
      await expect(sorting.words('noReadings')).toHaveCount(0)
      await expect(sorting.flags).toHaveCount(3)
      await sorting.presses('placeHow')
      await sorting.presses('start.best')
      await sorting.presses('play')
      await sorting.seesDone()
      for (const number of [1, 2, 3]) await expect(sorting.group(number)).toBeVisible()
    })

    test('two guess what counts on one device', async ({ child }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      await sorting.presses('guess.open')
      const game = child.dialog('sorting.guess.title')
      const press = (key: string) =>
        game.getByRole('button', { name: sorting.word(key), exact: true }).click()
      await press('feature.height')
      await press('guess.sort')
      // Round by round, until the other child is asked.
      await expect(game.getByText(sorting.word('guess.watch'))).toBeVisible()
      const asked = game.getByText(sorting.word('guess.second'))
      while (!(await asked.isVisible())) await press('guess.next')
      await press('feature.colour')
      await press('guess.check')
      await expect(game.getByText(sorting.word('guess.wrong', { found: 0, of: 1 }))).toBeVisible()
      await press('feature.colour')
      await press('feature.height')
      await press('guess.check')
      await expect(
        game.getByText(sorting.word('guess.right', { list: sorting.word('feature.height') })),
      ).toBeVisible()
      await press('guess.swap')
      await expect(game.getByText(sorting.word('guess.first'))).toBeVisible()
    })

    test('the cards are solved by their programs: groups on every tile, names on every colour', async ({
      child,
      page,
    }) => {
      for (const card of ['tidy-up', 'new-colours'] as const) {
        await child.opensProjectAtHome('Mine', sortingProject(card, 'solution'))
        await child.pressesStart()
        await new TimeHands(child).hurries()
        await child.seesCheck(card, 'shows', true, 60_000)
        // Flags and readings stand beside the world.
        await expect(page.getByRole('region', { name: child.word('sorting.collected.title') })).toBeVisible()
        await child.pressesStop()
      }
    })

    test('what Bo has collected opens in the playground, belongs to the project and goes home with it', async ({
      child,
      page,
    }) => {
      const sorting = new SortingHands(child)
      await child.opensProjectAtHome('Mine', sortingProject('new-colours', 'solution'))
      await child.pressesStart()
      await new TimeHands(child).hurries()
      await child.seesCheck('new-colours', 'shows', true, 60_000)
      await child.presses('lab.menu')
      await child.presses('robot.collected')
      await expect(sorting.flags).toHaveCount(3)
      await sorting.sorts()
      await sorting.group(1).fill('Sky')
      await child.seesSaved()
      await page.getByRole('link', { name: sorting.word('toProgram') }).click()
      await child.seesLab()
      const text = await child.savesFile()
      const { sorting: kept } = JSON.parse(text) as { sorting: { version: number; names: string[] } }
      expect(kept).toMatchObject({ version: 1, source: 'readings', names: ['Sky'] })
      await page.evaluate(async () => {
        for (const { name } of await indexedDB.databases()) indexedDB.deleteDatabase(name!)
      })
      await child.opensHome()
      await child.opensFileAtHome('home.botgarten.json', text)
      await child.seesLab()
      await child.presses('lab.menu')
      await child.presses('robot.sorting')
      await expect(sorting.group(1)).toHaveValue('Sky')
    })

    test('Ctrl and Z take back a step of sorting, a name too; a field takes back its letters', async ({
      child,
    }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      const before = await sorting.places()
      await child.tabsTo(sorting.flag(1))
      await child.types('ArrowLeft')
      await expect.poll(() => sorting.places()).not.toEqual(before)
      await child.types('Control+z')
      await expect.poll(() => sorting.places()).toEqual(before)
      await child.types('Control+y')
      await expect.poll(() => sorting.places()).not.toEqual(before)
      await sorting.group(2).fill('Cups')
      await sorting.plane.focus()
      await child.types('Control+z')
      await expect(sorting.group(2)).toHaveValue('')
    })

    test('hints come one after the other, only when they are asked for', async ({ child, page }) => {
      const sorting = new SortingHands(child)
      await sorting.opens()
      const hint = page.getByRole('region', { name: child.word('lab.hint'), exact: true })
      await expect(hint).toHaveCount(0)
      await child.presses('lab.hint')
      await expect(hint).toContainText(sorting.word('hint.things1'))
      await child.presses('lab.hintNext')
      await child.presses('lab.hintNext')
      await expect(hint).toContainText(sorting.word('hint.things3'))
      await child.presses('parts.close')
      await expect(hint).toHaveCount(0)
    })

    test('a table whose commas can be either is read as two columns, and as one when the child says so', async ({
      child,
    }) => {
      const sorting = new SortingHands(child)
      await sorting.opens('points')
      await sorting.opensTable('1,5\n2,25\n9,75\n')
      await expect(sorting.words('feature.up')).toHaveCount(0)
      await expect(sorting.words('table.either')).toBeVisible()
      await sorting.presses('table.oneColumn')
      await expect(sorting.words('table.either')).toHaveCount(0)
      await sorting.seesPoints(3)
      await sorting.opensTable('Länge\n1,5\n2,25\n')
      await sorting.seesPoints(2)
      await expect(sorting.words('table.either')).toHaveCount(0)
      await expect(child.page.getByText('Länge', { exact: true })).toBeVisible()
    })

    test('a project that is not there is not opened, and that is said', async ({ child, page }) => {
      const sorting = new SortingHands(child)
      // By address: a link to a project of another device.
      await page.goto('/sorting?p=nobody')
      await expect(page.getByText(sorting.word('say.missing'))).toBeVisible()
      await sorting.sorts()
      await sorting.seesDone()
      await expect(page.getByRole('link', { name: sorting.word('toProgram') })).toHaveCount(0)
    })
  })
}
