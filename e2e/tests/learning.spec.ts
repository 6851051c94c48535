// Rooms: q-learning
import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`learning by trying in ${language}`, () => {
    test.use({ language })

    test('the railway: a road is closed on the map, Bo learns, the way is drawn, and Bo stands at the goal', async ({
      child,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.closes(2, 3)
      await learner.seesClosedRoads(2)
      await child.presses('lab.undo')
      await learner.seesClosedRoads(0)
      await learner.closes(2, 3)
      await learner.hurries()
      await child.presses('lab.start')
      await learner.seesWay(3, 5, 0, 1)
      await child.seesDriving()
      const time = new TimeHands(child)
      await time.opens()
      await time.chooses('Infinity')
      await child.seesCheck('railway', 'way')
      await child.seesCheck('railway', 'arrives')
      await expect(child.button('lab.stop')).toHaveCount(0)
    })

    test('another map is chosen in the block while Bo drives: Bo stops, and the new map is to be learned', async ({
      child,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.hurries()
      await child.presses('lab.start')
      await child.seesDriving()
      await learner.choosesMapInBlock('railway', 'mars')
      await expect(child.button('lab.stop')).toHaveCount(0)
      await learner.sees()
      await child.presses('lab.fold')
      await expect(child.words('q.nothingYet')).toBeVisible()
    })

    test('after a setting is changed all parts say that nothing is learned, also with the world in front', async ({
      child,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.learnsToTheEnd()
      await child.presses('q.largeFloor')
      await expect(learner.floor).toBeVisible()
      await expect(child.words('q.nothingYet')).toHaveCount(0)
      await child.presses('q.largeMap')
      await learner.makesStation(4, 'startHere')
      for (const part of ['q.largeFloor', 'q.largeMap']) {
        await expect(child.words('q.nothingYet')).toBeVisible()
        await expect(learner.floor).toHaveCount(0)
        await child.presses(part)
      }
    })

    test('by keys alone', async ({ child }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await child.tabsTo(learner.station(0))
      // Six stations, then the roads 0–1, 0–5, 1–2, 2–3.
      for (let step = 0; step < 9; step += 1) await child.types('ArrowRight')
      await expect(learner.road(2, 3)).toBeFocused()
      await child.types('Enter')
      await expect(child.button('q.closeRoad')).toBeFocused()
      await child.types('Enter')
      await learner.seesClosedRoads(2)
      await child.tabsAndPresses('q.turbo')
      await child.tabsAndPresses('lab.start')
      await learner.seesWay(3, 5, 0, 1)
      await child.tabsAndPresses('time.open')
      await child.tabsTo(new TimeHands(child).speed)
      await child.types('End')
      await child.seesCheck('railway', 'arrives')
    })

    test('what was learned when the page was left goes on, and the same dice give the same', async ({
      child,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await child.presses('q.times', { speed: 3 })
      await learner.learns()
      await expect.poll(async () => (await learner.moves()).made).toBeGreaterThan(3)
      await child.presses('q.pause')
      const { made } = await learner.moves()
      const said = await child.page.locator('.q > [aria-live]').textContent()
      await child.seesSaved()
      await child.reloads()
      await learner.sees()
      await expect.poll(() => learner.moves()).toEqual({ shown: made, made })
      await child.presses('q.step')
      await expect.poll(() => learner.moves()).toEqual({ shown: made + 1, made: made + 1 })
      await learner.timeline.focus()
      await child.types('ArrowLeft')
      await expect.poll(() => learner.moves()).toEqual({ shown: made, made: made + 1 })
      await expect(child.page.locator('.q > [aria-live]')).toHaveText(said!)
    })

    test('a step is said, a run becomes a row and three curves', async ({ child, page }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      const learner = new Learner(child)
      await learner.opens('railway')
      await child.presses('q.step')
      const facts = { move: 1, from: '\\d', to: '\\d', how: '.+', stars: '[\\d½]+' }
      await expect(page.locator('.q > [aria-live]')).toHaveText(new RegExp(child.word('q.said.move', facts)))
      await learner.learnsToTheEnd()
      await child.presses('lab.stop')
      await learner.turnsTo('curves')
      await expect(page.locator('.drawer figure')).toHaveCount(3)
      await learner.turnsTo('trials')
      await expect(page.locator('.drawer tbody tr')).toHaveCount(1)
    })
  })
}
