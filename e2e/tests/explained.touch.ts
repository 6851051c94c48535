// Rooms: network, inside
import { AskingHands } from '../child-explained.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(200)])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`what a block does, by a finger, in ${language}`, () => {
    test.use({ language })

    test('a finger that rests on a block of the shelf or of the program is told, and takes the example', async ({
      child,
    }) => {
      const hands = new AskingHands(child)
      await child.opensProjectAtHome('Waits', waits)
      const blocks = child.canvas.locator('> .blocklyDraggable')
      const before = await blocks.count()
      await hands.blocks.row('control').tap()
      await hands.asksByFinger(hands.onShelf(1))
      await hands.isTold('robControls_loopForever')
      await hands.dialog.getByRole('button', { name: child.word('parts.close') }).tap()
      await expect(hands.dialog).toBeHidden()
      await hands.asksByFinger(child.block('b2'))
      await hands.isTold('robControls_wait_time')
      await hands.dialog.getByRole('button', { name: child.word('shelf.take') }).tap()
      await expect(hands.dialog).toBeHidden()
      await expect(blocks).toHaveCount(before + 1)
    })
  })
}
