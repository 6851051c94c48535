import { mapField } from '@botgarten/blocks'
import { content } from '@botgarten/content/files'
import { placeOf } from '@botgarten/maps'
import type { Facts } from '@botgarten/messages'
import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { settingsOf, variantsOf } from '../variant.ts'

/** Where Bo drives no way, by the sentence that says why: a move may lead somewhere else, or going round pays more than the goal. */
const chance = ['q.chance', { value: '.+', best: '.+', rides: '\\d+' }] as const
const withoutWay: { readonly [map: string]: readonly [key: string, facts: Facts] } = {
  ...{ bandit: chance, lake: chance, 'lake-8': chance },
  roundabout: ['q.circlePays', { circle: '.+' }],
}

/** cm from the middle of the goal's station at which Bo may stop. */
const near = 12

for (const { map, variant } of content.maps.flatMap((map) =>
  variantsOf(map).map((variant) => ({ map, variant })),
)) {
  test.describe(`the map ${map} in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

    test('is chosen by its name, learned on to the end, and its way driven, where there is one', async ({
      child,
      page,
    }) => {
      const learner = new Learner(child)
      await learner.opens('railway')
      await learner.choosesMap(child.word(`choice.${mapField(map)}`))
      await learner.givesTries(1000, 100_000)
      await learner.hurries()
      await learner.learns()
      await learner.seesEnd()
      const why = withoutWay[map]
      if (why) {
        await expect(page.getByText(new RegExp(child.word(...why))).first()).toBeVisible()
        await expect(learner.floor).toBeHidden()
        return
      }
      await expect(learner.floor).toBeVisible()
      const way = await learner.way()
      const goal = placeOf(content.mapFile(map)!, way.at(-1)!)
      const time = new TimeHands(child)
      await time.opens()
      await time.hurries()
      const away = async () => {
        const [x, y] = (await child.boStands()).split(',').map(Number)
        return Math.hypot(x! - goal.x, y! - goal.y)
      }
      await expect.poll(away, { timeout: 240_000 }).toBeLessThan(near)
    })
  })
}
