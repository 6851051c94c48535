// Rooms: editor, blocks
import { BlockHands } from '../child-blocks.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { besides, friends } from '../projects-language.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`blocks and what they mean, by a finger, in ${language}`, () => {
    test.use({ language })

    test('only what fits is joined: a number goes where a number belongs, a text stays out', async ({
      child,
    }) => {
      const hands = new BlockHands(child)
      await child.opensProjectAtHome('Beside', besides())
      const inWait = child.block('b4').locator('[data-id]')
      await hands.joins('hand', 'b1', 'b3')
      await expect(inWait).toHaveAttribute('data-id', 'b3')
      await hands.joins('hand', 'b2', 'b3')
      await expect(inWait).toHaveAttribute('data-id', 'b2')
    })

    test('a robot reads on its display what another has sent it', async ({ child }) => {
      const bo = new RobotHands(child)
      await child.opensProjectAtHome('Friends', friends())
      await new BlockHands(child).joins('hand', 'b1', 'b2')
      await new TimeHands(child).chip(2).tap()
      await bo.opens('panel')
      await child.button('lab.start').first().tap()
      await expect(bo.drawer('panel').getByLabel(bo.word('display'))).toHaveText('tok')
    })
  })
}
