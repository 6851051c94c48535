import { Learner } from '../child-learning.ts'
import { MapMaker } from '../child-maps.ts'
import { expect, follows, test } from './gate.ts'

test.use({ language: 'en' })

test(
  'a map is drawn, tried by Bo, learned on, and is still offered after a reload',
  {
    tag: ['@map-designer', '@/maps'],
  },
  async ({ child, page }) => {
    const maker = new MapMaker(child)
    const learner = new Learner(child)
    await follows(child, 'home.maps')
    await child.presses('design.new')
    await maker.draws()
    await child.presses('design.undo')
    await expect(child.words('design.reached', { start: 0, goal: 2, count: 2 })).toHaveCount(0)
    await child.presses('design.redo')
    await maker.learnsAndDrives((thing) => thing.click(), 0, 1, 2)
    await child.seesSaved()
    await page.reload()
    await learner.sees()
    await expect(learner.station(2)).toBeVisible()
    await follows(child, 'home.maps')
    await expect(page.getByText(child.word('design.newName')).first()).toBeVisible()
    await child.presses('rooms.new')
    const kinds = page.getByRole('region', { name: child.word('rooms.tools') })
    await kinds.getByRole('button', { name: child.word('rooms.kind.trap'), exact: true }).click()
    const room = page
      .getByRole('group', { name: child.word('rooms.field'), exact: true })
      .getByRole('button')
      .nth(2)
    await room.click()
    await expect(room).toHaveAccessibleName(new RegExp(child.word('rooms.kind.trap')))
  },
)
