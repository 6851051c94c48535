// Rooms: map-designer, q-learning
import type { Locator } from '@playwright/test'
import { Learner } from '../child-learning.ts'
import { MapMaker } from '../child-maps.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a map of one's own in ${language}`, () => {
    test.use({ language })

    test('is drawn from home on, tried by Bo, learned on, and still there after a reload', async ({
      child,
      page,
    }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.word('home.maps'), exact: true }).click()
      await child.presses('design.new')
      const paper = page.getByRole('group', { name: child.word('design.paper'), exact: true })
      const box = (await paper.boundingBox())!
      const at = (x: number, y: number) => [box.x + x * box.width, box.y + y * box.height] as const
      const places = [at(0.15, 0.7), at(0.5, 0.25), at(0.85, 0.7)]
      for (const place of places) await page.mouse.click(...place)
      await child.presses('design.tool.road')
      for (const [from, to] of [
        [0, 1],
        [1, 2],
        [0, 2],
      ] as const) {
        await page.mouse.move(...places[from]!)
        await page.mouse.down()
        await page.mouse.move(...at(0.5, 0.5), { steps: 3 })
        await page.mouse.move(...places[to]!, { steps: 3 })
        await page.mouse.up()
      }
      // By keys: the third station is the goal.
      await child.button('design.station', { station: 2 }).focus()
      await child.presses('design.goalHere')
      await expect(
        page.getByText(child.word('design.reached', { start: 0, goal: 2, count: 1 })),
      ).toBeVisible()
      await expect(page.getByText(child.word('design.triedCount', { count: 3, all: 3 }))).toBeVisible()
      await child.presses('design.undo')
      await child.presses('design.redo')
      await child.presses('design.learn')
      const learner = new Learner(child)
      await learner.sees()
      await page.reload()
      await learner.sees()
      await expect(learner.station(2)).toBeVisible()
    })

    test('names of stations are on the map, on paper, and in the lab for eyes and ears', async ({
      child,
      page,
    }) => {
      const maker = new MapMaker(child)
      await maker.begins((thing) => thing.click())
      await maker.draws()
      const names = ['Haus', 'Brunnen', 'Schule']
      for (const [station, name] of names.entries()) {
        await maker.station(station).focus()
        const field = page.getByRole('textbox', { name: child.word('design.name'), exact: true }).last()
        await field.fill(name)
        await field.press('Enter')
        const named = `${child.word('design.station', { station })}, ${name}`
        await expect(page.getByRole('button', { name: named, exact: true }).getByText(name)).toBeVisible()
      }
      await page.emulateMedia({ media: 'print' })
      await expect(page.locator('.printed-map')).toContainText('2 Schule')
      const printed = await page.locator('.printed-map img').getAttribute('src')
      for (const name of names) expect(decodeURIComponent(printed!)).toContain(`>${name}</text>`)
      await page.emulateMedia({ media: 'screen' })
      await child.presses('design.learn')
      await new Learner(child).sees()
      const named = `${child.word('q.station', { station: 1 })}, Brunnen`
      await expect(page.getByRole('button', { name: named, exact: true })).toBeVisible()
      await expect(page.locator('#stations').getByText('Brunnen')).toBeVisible()
      await expect(page.locator('.ends').getByText('Schule')).toBeVisible()
    })

    test('the tiles of the maps have as much room on their left as on their right', async ({
      child,
      page,
    }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.word('home.maps'), exact: true }).click()
      await expect(page.getByRole('button', { name: child.word('design.new') })).toBeVisible()
      const aside = () =>
        page.locator('main ul').evaluateAll((lists) => {
          const tiles = lists.flatMap((list) =>
            [...list.children].map((tile) => tile.getBoundingClientRect()),
          )
          const left = Math.min(...tiles.map((tile) => tile.left))
          const right = document.documentElement.clientWidth - Math.max(...tiles.map((tile) => tile.right))
          return Math.abs(left - right)
        })
      for (const width of [1366, 1024, 800]) {
        await page.setViewportSize({ width, height: 768 })
        await expect.poll(aside).toBeLessThan(3)
      }
    })

    test('a world of rooms is chosen from home on, and Bo learns there', async ({ child, page }) => {
      await child.opensHome()
      await page.getByRole('link', { name: child.word('home.maps'), exact: true }).click()
      const cliff = child.word('choice.MAP_CLIFF')
      await page.getByRole('button', { name: cliff, exact: true }).click()
      const learner = new Learner(child)
      await learner.sees()
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(cliff)
      await child.seesSaved()
      await learner.learnsToTheEnd()
    })

    test('is made by keys alone, from the list to the print, and driven', async ({ child }) => {
      const maker = new MapMaker(child)
      const press = async (thing: Locator) => {
        await child.tabsTo(thing)
        await child.types('Enter')
      }
      await maker.begins(press)
      await maker.lists(press)
      await child.tabsTo(child.button('design.station', { station: 2 }))
      await press(child.button('design.goalHere'))
      await maker.seesReached(2)
      await maker.prints(press)
      await maker.learnsAndDrives(press, 0, 1, 2)
    })
  })
}
