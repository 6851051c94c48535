// Rooms: q-learning
import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import { test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language, motion: true })

    test('lets Bo learn the railway with a finger, from the closed road to the goal', async ({ child }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.road(2, 3).tap()
      await child.button('q.closeRoad').tap()
      await learner.seesClosedRoads(2)
      await child.button('q.turbo').tap()
      await child.button('lab.start').first().tap()
      await learner.seesWay(3, 5, 0, 1)
      const time = new TimeHands(child)
      await time.opens()
      await time.chooses('Infinity')
      await child.seesCheck('railway', 'arrives')
    })
  })
}
