// Rooms: network
import { LooseHands } from '../child-loose.ts'
import { leftEye, leftWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram, looseNet } from '../projects.ts'
import { languagesOf } from '../words.ts'

const loop = freeProgram('Loop', (make) => [make.forever()])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a network that nothing starts, in ${language}`, () => {
    test.use({ language })

    test('dropped where the network is to be, it goes into the loop; one undo takes it back', async ({
      child,
    }) => {
      const hands = new LooseHands(child)
      await child.opensProjectAtHome('Loop', loop)
      await hands.dropsNetwork()
      await hands.seesNumbers()
      await child.presses('lab.undo')
      await expect(child.words('network.empty')).toBeVisible()
      // Undone is undone: nothing of it is left on the paper.
      await expect(child.canvas.locator('.ai_neural_network')).toHaveCount(0)
    })

    test('by keys alone one comes in, and one that hangs loose too', async ({ child, page }) => {
      const hands = new LooseHands(child)
      await child.opensProjectAtHome('Loop', loop)
      await expect(child.words('network.empty')).toBeHidden()
      await child.tabsAndPresses('lab.unfoldNetwork')
      await child.tabsAndPresses('network.putOne')
      await hands.seesNumbers()
      await expect(child.knobs.first()).toBeFocused()
      // Before Start the sum is what would be, in a run what was, and after the turn of a knob in a pause what would be again.
      await hands.saysWouldBe()
      await child.pressesStart()
      await hands.saysWouldBe(false)
      await child.presses('lab.pause')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await hands.saysWouldBe()
      await child.pressesStop()
      await child.opensProject('Loose', looseNet('Loose'))
      await hands.seesLoose()
      await child.tabsAndPresses('network.leaveLoose')
      await expect(hands.note).toHaveCount(0)
      await expect(child.button('problem.looseNetwork.title')).toBeFocused()
      await child.types('Enter')
      await expect(child.button('problem.fix.intoLoop')).toBeFocused()
      await child.types('Enter')
      await hands.seesNumbers()
      await page.keyboard.press('ControlOrMeta+z')
      await hands.seesLoose()
    })
  })
}
