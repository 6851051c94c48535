import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'Bo learns by trying: a road is closed, a value rises, the way is found and driven to the goal',
  {
    tag: ['@q-learning', '@/lab/[card]'],
  },
  async ({ child, page }) => {
    const learner = new Learner(child)
    const time = new TimeHands(child)
    await learner.opens('railway')
    await learner.closes(2, 3)
    await learner.seesClosedRoads(2)
    await child.presses('q.step')
    await expect.poll(async () => (await learner.moves()).made).toBe(1)
    const facts = { move: 1, from: '\\d', to: '\\d', how: '.+', stars: '[\\d½]+' }
    await expect(page.locator('.q > [aria-live]')).toHaveText(new RegExp(child.word('q.said.move', facts)))
    // The road into the goal has the value 0 before the first visit.
    const last = (value: string, tries: number) => child.word('q.cell', { from: 0, to: 1, value, tries })
    await expect(page.getByRole('button', { name: last('0', 0), exact: true })).toBeVisible()
    await learner.hurries()
    await child.presses('lab.start')
    await learner.seesWay(3, 5, 0, 1)
    await child.seesDriving()
    await expect(page.getByRole('button', { name: last('0', 0), exact: true })).toHaveCount(0)
    await time.opens()
    await time.hurries()
    await child.seesCheck('railway', 'way')
    await child.seesCheck('railway', 'arrives')
    await learner.turnsTo('trials')
    await expect(page.locator('.drawer tbody tr')).toHaveCount(1)
    expect(await learner.savesTable()).toContain('3-5-0-1')
  },
)

test(
  'a guess on the map is compared with the way that Bo has learned',
  { tag: '@q-learning' },
  async ({ child }) => {
    const learner = new Learner(child)
    await learner.opens('railway')
    await learner.closes(2, 3)
    await learner.guesses(4, 5, 0, 1)
    await child.presses('q.guessing.learn')
    await learner.hurries()
    await expect(child.words('q.compare.shorter', { count: 1 })).toBeVisible()
    await learner.seesWay(3, 5, 0, 1)
  },
)
