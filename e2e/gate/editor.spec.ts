import { BlockHands } from '../child-blocks.ts'
import { expect, opensProject, poseOf, test } from './gate.ts'
import { freeProgram } from '../projects.ts'

test.use({ language: 'en' })

test(
  'a block is dragged out of the toolbox, runs, is undone, and another one is found by a word',
  {
    tag: '@editor',
  },
  async ({ child, page }) => {
    const hands = new BlockHands(child)
    const blocks = child.canvas.locator('.blocklyDraggable')
    await opensProject(
      child,
      'Empty',
      freeProgram('Empty', () => []),
    )
    await hands.row('action').click()
    const drive = page.locator('.blocklyFlyout .robActions_motorDiff_on_for').first()
    await expect(drive).toBeVisible()
    const [from, start] = [(await drive.boundingBox())!, (await blocks.first().boundingBox())!]
    await child.drags({ x: from.x + 8, y: from.y + 12 }, { x: start.x + 8, y: start.y + start.height + 6 })
    await expect(page.locator('.blocklyDragging')).toHaveCount(0)
    await expect(child.canvas.locator('.robControls_start .robActions_motorDiff_on_for')).toHaveCount(1)
    const before = await poseOf(child)
    await child.pressesStart()
    await expect(child.button('lab.start').first()).toBeVisible()
    const after = await poseOf(child)
    expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeGreaterThan(10)

    await child.presses('lab.undo')
    await expect(blocks).toHaveCount(1)
    await hands.searches('repeat')
    await hands.hits.first().click()
    await expect(child.canvas.locator('.robControls_loopForever, .controls_repeat_ext')).toHaveCount(1)
    await hands.all.click()
    await expect(hands.row('lists')).toBeVisible()
  },
)
