// Rooms: q-learning
import { Learner, learningProject } from '../child-learning.ts'
import { RobotHands } from '../child-robot.ts'
import { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the playground for learning by trying in ${language}`, () => {
    test.use({ language, motion: true })

    test('hedges open and streets get clean where a way is good', async ({ child }) => {
      const learner = new Learner(child)
      for (const [card, last] of [
        ['forest', '5-7|6-7'],
        ['city', '14-15|15-16|13-15'],
      ] as const) {
        await learner.opens(card)
        const closed = await learner.covers()
        expect(new Set(closed)).toEqual(new Set([1]))
        await learner.station(9).click()
        await expect(learner.row(9)).toHaveClass(/tapped/)
        await expect(learner.row(9)).toBeInViewport({ ratio: 0.99 })
        await child.types('Escape')
        await child.presses('q.step')
        await learner.seesAllTogether(card === 'forest' ? 'all' : 'now')
        await learner.learnsToTheEnd()
        const best = Math.min(...(await learner.covers(last)))
        expect(best).toBeLessThan(0.1)
        await expect.poll(async () => Math.max(...(await learner.covers()))).toBeGreaterThan(best)
      }
    })

    test('on Mars fog lifts where Bo has been, and the way through three rooms by three is found', async ({
      child,
      page,
    }) => {
      const learner = new Learner(child)
      await learner.opensProject(
        'Mars',
        learningProject('Mars', { MAP: 'MAP_MARS', START: '0', FINISH: '8' }),
      )
      await expect(page.locator('#fog-8')).toBeVisible()
      await learner.hurries()
      await learner.learns()
      await learner.seesWay(0, 3, 4, 5, 8)
      await expect(page.locator('#fog-8')).toBeHidden()
      await child.seesDriving()
    })

    test('every choice of the blocks that learn lies in its pane and opens', async ({ child, page }) => {
      const learner = new Learner(child)
      const choices = child.canvas.locator(
        ['learner_config', 'learning_states_and_actions_map']
          .map((type) => `.ai_q_${type} > .blocklyDropdownField`)
          .join(),
      )
      for (const card of ['railway', 'forest'] as const) {
        await learner.opens(card)
        await learner.unfolds()
        await expect(choices).toHaveCount(5)
        for (const choice of await choices.all()) {
          const { width, height } = (await choice.boundingBox())!
          // What lies beyond the edge of the pane takes no click.
          await choice.click({ position: { x: width - 6, y: height / 2 } })
          await expect(page.locator('.blocklyDropDownDiv').getByRole('option').first()).toBeVisible()
          await child.types('Escape')
        }
      }
    })

    test('start and goal change places in one step, and one step takes it back', async ({ child, page }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.makesStation(1, 'startHere')
      const task = (start: number, goal: number) =>
        page.getByRole('region', { name: child.word('q.task', { start, goal }) })
      await expect(task(1, 3)).toBeVisible()
      await child.presses('lab.undo')
      await expect(task(3, 1)).toBeVisible()
      await expect(child.button('lab.undo')).toHaveAttribute('aria-disabled', 'true')
      await child.presses('q.change')
      await page.getByRole('combobox', { name: child.word('q.goal'), exact: true }).selectOption('4')
      await child.types('Escape')
      await expect(task(3, 4)).toBeVisible()
    })

    test('a row of the table and its road on the map show each other', async ({ child, page }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      const cell = page.getByRole('button', {
        name: child.word('q.cell', { from: 3, to: 5, value: 0, tries: 0 }),
      })
      await cell.hover()
      await expect(page.locator('path.marked')).toHaveCount(1)
      await child.presses('q.step')
      await learner.seesAllTogether('all')
      await learner.road(3, 5).focus()
      await expect(cell).toHaveClass(/marked/)
      await expect(page.locator('.drawer .marked')).toHaveCount(1)
    })

    test('a guess on the map is compared with what came out, on the screen and in the table', async ({
      child,
      page,
    }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.closes(2, 3)
      await learner.guesses(4, 5, 0)
      await expect(child.button('q.guessing.learn')).toHaveAttribute('aria-disabled', 'true')
      await learner.station(1).focus()
      await child.types('Enter')
      await child.presses('q.guessing.learn')
      await learner.hurries()
      await expect(page.getByText(child.word('q.compare.shorter', { count: 1 }))).toBeVisible()
      await learner.seesWay(3, 5, 0, 1)
      await child.presses('q.inside')
      await learner.turnsTo('trials')
      await expect(page.locator('.drawer tbody tr')).toContainText(
        child.word('q.closedRoads', { roads: '2–3' }),
      )
      const [head, ...rows] = (await learner.savesTable()).trim().split('\r\n')
      expect(head).toMatch(/^map,start,goal,/)
      expect(rows).toHaveLength(1)
      expect(rows[0]).toMatch(
        /^railway,3,1,\d-\d \d-\d,standard,0\.5,0\.8,0\.1,0\.5,10,10000,1,10,\d+,3-5-0-1,3,\d+,3-4-5-0-1,$/,
      )
      await child.presses('q.letDrive')
      await child.seesDriving()
    })

    test('what Bo senses stands beside the floor that it drives on', async ({ child, page }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.closes(2, 3)
      await learner.hurries()
      await child.presses('lab.start')
      await expect(learner.floor).toBeVisible()
      const bo = new RobotHands(child)
      const floor = page.getByRole('application', { name: child.word('world.label') })
      for (const what of ['senses', 'panel'] as const) {
        await bo.opens(what)
        const [left, right] = [(await floor.boundingBox())!, (await bo.drawer(what).boundingBox())!]
        expect(left.width).toBeGreaterThan(300)
        expect(right.x).toBeGreaterThanOrEqual(left.x + left.width)
      }
    })

    test('a link carries the dice to another device, which learns the same', async ({
      browser,
      child,
      contextOptions,
      locale,
      page,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.learnsToTheEnd()
      await learner.turnsTo('trials')
      const link = page.getByRole('link', { name: child.word('q.diceLink'), exact: true })
      await expect(link).toHaveAttribute('href', /\/lab\/railway\?dice=1$/)
      await child.presses('q.again')
      await expect(page.locator('.drawer tbody tr')).toHaveCount(2)
      const [, first, second] = (await learner.savesTable()).split('\r\n')
      expect(second).toBe(first)

      const device = await browser.newContext({ ...contextOptions, locale })
      const there = new Learner(new Child(await device.newPage(), language))
      // By address: the link itself.
      await there.child.page.goto(await link.evaluate(({ href }: HTMLAnchorElement) => href))
      await there.sees()
      await there.learnsToTheEnd()
      await there.turnsTo('trials')
      expect((await there.savesTable()).split('\r\n')[1]).toBe(first)
      await device.close()
    })

    test('each move is said as a sentence while it is played', async ({ child, page }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      const heard = await learner.listens()
      await learner.learns()
      const facts = (move: number) => ({ move, from: '\\d', to: '\\d', how: '.+', stars: '[\\d½]+' })
      for (const move of [1, 2, 3])
        await expect
          .poll(heard)
          .toContainEqual(expect.stringMatching(new RegExp(child.word('q.said.move', facts(move)))))
      await child.presses('q.stop')
      await expect(page.locator('.q > [aria-live]')).toContainText(child.word('q.byHand'))
      // After the end there is nothing to step.
      await expect(
        page.locator('.q').getByRole('button', { name: child.word('q.step'), disabled: false }),
      ).toHaveCount(0)
    })

    test('twice as fast is twice as many moves, three times three times', async ({ child, page }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await page.clock.install()
      await page.clock.pauseAt(Date.now() + 60_000)
      const made: number[] = []
      for (const speed of [1, 2, 3]) {
        await child.presses('q.times', { speed })
        await learner.learns()
        await page.clock.runFor(6050)
        await child.presses('q.pause')
        made.push((await learner.moves()).made)
        await child.presses('q.again')
      }
      // The first one begins at once.
      expect(made).toEqual([7, 13, 19])
    })

    test('who wants less motion sees Bo jump, hears every move, and nothing moves', async ({
      child,
      page,
    }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      const learner = new Learner(child)
      await learner.opens('railway')
      const heard = await learner.listens()
      await learner.learns()
      const places = await learner.places(2500)
      expect(places.size).toBeLessThanOrEqual(4)
      await expect.poll(() => page.evaluate(() => document.getAnimations().map(({ id }) => id))).toEqual([])
      const facts = { move: 1, from: '\\d', to: '\\d', how: '.+', stars: '[\\d½]+' }
      await expect
        .poll(heard)
        .toContainEqual(expect.stringMatching(new RegExp(child.word('q.said.move', facts))))
    })

    test('rewards of one’s own: length counts, a station pays, and both stand in the table', async ({
      child,
      page,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.turnsTo('inside')
      await page.getByLabel(child.word('q.level')).selectOption('explorer')
      await page.getByLabel(child.word('q.pay.length')).check()
      await learner.turnsTo('map')
      await learner.station(4).click()
      const reward = page.getByLabel(child.word('q.pay.here'), { exact: true })
      await reward.fill(language === 'de' ? '2,5' : '2.5')
      await reward.press('Enter')
      await child.presses('q.close')
      const coin = page.getByText(language === 'de' ? '+2,5' : '+2.5', { exact: true })
      await expect(coin).toBeVisible()
      await child.presses('lab.undo')
      await expect(coin).toHaveCount(0)
      await child.presses('lab.redo')
      await expect(coin).toBeVisible()
      await learner.learnsToTheEnd()
      await learner.turnsTo('trials')
      expect(await learner.savesTable()).toMatch(/,length 4:2\.5\r\n$/)
    })
  })
}
