// Rooms: q-learning
import { Learner, learningProject } from '../child-learning.ts'
import { expect, test } from '../house.ts'

test.use({ motion: true })

test('a circle that pays more than arriving is walked on the map', async ({ child, page }) => {
  test.slow()
  const learner = new Learner(child)
  await child.opensLab('cheating')
  await learner.sees()
  await learner.hurries()
  await child.presses('lab.start')
  await expect(child.button('q.watch.once')).toBeVisible()
  await expect(page.getByText(child.word('q.circleEnd')).first()).toBeVisible()
  const places = await learner.places(2500)
  expect(places.size).toBeGreaterThan(20)
  await expect(page.locator('.bar').getByRole('button', { name: child.word('q.playNew') })).toBeVisible()
})

test('on ice ten rides are watched, and counted', async ({ child, page }) => {
  const learner = new Learner(child)
  await learner.opensProject(
    'Ice',
    learningProject('Ice', { MAP: 'MAP_LAKE', START: '0', FINISH: '15' }, 1000),
  )
  // Rooms have their numbers on the map.
  await expect(page.locator('.space text.room')).toHaveText(
    Array.from({ length: 16 }, (_, room) => String(room)).filter(
      (room) => !['5', '7', '11', '12', '15'].includes(room),
    ),
  )
  await learner.hurries()
  await child.presses('lab.start')
  await expect(child.button('q.watch.rides', { count: 10 })).toBeVisible()
  await expect(
    page.getByText(new RegExp(child.word('q.watch.now', { ride: '\\d+', count: 10, arrived: '\\d' }))),
  ).toBeVisible()
  const done = page.getByText(new RegExp(child.word('q.watch.done', { arrived: '\\d+', count: 10 })))
  await expect(done).toBeVisible()
  const said = await done.textContent()
  await child.presses('q.watch.rides', { count: 10 })
  await expect(done).toHaveCount(0)
  await expect(done).toHaveText(said!)
})

test('Bo drives what it learned, and says so, though the choice of start and goal is open', async ({
  child,
}) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await child.presses('q.change')
  await learner.hurries()
  await learner.learns()
  await learner.seesEnd()
  await expect(learner.floor).toBeVisible()
})

test('with a start the opened program folds, and the bar of the map is free', async ({ child }) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await learner.unfolds()
  await child.presses('lab.start')
  await expect(child.button('lab.unfold').first()).toBeVisible()
  await child.presses('q.pause')
})
