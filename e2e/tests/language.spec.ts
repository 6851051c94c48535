// Rooms: editor, blocks
import { BlockHands } from '../child-blocks.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { besides, friends } from '../projects-language.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`blocks and what they mean, in ${language}`, () => {
    test.use({ language })

    for (const by of ['hand', 'keys'] as const)
      test(`only what fits is joined by ${by}: a number goes where a number belongs, a text stays out`, async ({
        child,
      }) => {
        const hands = new BlockHands(child)
        await child.opensProjectAtHome('Beside', besides())
        const inWait = child.block('b4').locator('[data-id]')
        await expect(inWait).toHaveAttribute('data-id', 'b3')
        await hands.joins(by, 'b1', 'b3')
        await expect(inWait).toHaveAttribute('data-id', 'b3')
        await hands.joins(by, 'b2', 'b3')
        await expect(inWait).toHaveAttribute('data-id', 'b2')
      })

    for (const by of ['hand', 'keys'] as const)
      test(`a robot reads on its display what another has sent it, put together by ${by}`, async ({
        child,
      }) => {
        const robots = new TimeHands(child)
        const bo = new RobotHands(child)
        await child.opensProjectAtHome('Friends', friends())
        await new BlockHands(child).joins(by, 'b1', 'b2')
        if (by === 'hand') await robots.chip(2).click()
        else {
          await child.tabsTo(robots.chip(2))
          await child.types('Enter')
        }
        await bo.opens('panel')
        // It ends at once.
        if (by === 'hand') await child.presses('lab.start')
        else await child.tabsAndPresses('lab.start')
        await expect(bo.drawer('panel').getByLabel(bo.word('display'))).toHaveText('tok')
      })
  })
}
