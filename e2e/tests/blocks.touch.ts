// Rooms: editor
import { BlockHands } from '../child-blocks.ts'
import type { Child } from '../child.ts'
import { finger } from '../hand.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(200)])
/** A program to put blocks into, and how many it has. */
async function opensWaits(child: Child) {
  await child.opensProjectAtHome('Waits', waits)
  const blocks = child.canvas.locator('.blocklyDraggable')
  return { hands: new BlockHands(child), blocks, before: await blocks.count() }
}

const searched = { en: 'if', de: 'wenn' } as const

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`blocks by a finger, in ${language}`, () => {
    test.use({ language })

    test('a block that is found is pulled out of the list and lies where the finger lets go, in one step', async ({
      child,
      page,
    }) => {
      const { hands, blocks, before } = await opensWaits(child)
      await hands.searches(searched[language])
      const hit = hands.hits.first()
      await expect(hit).toContainText(new RegExp(searched[language], 'i'))
      const stands = (await child.block('b5').boundingBox())!
      const to = { x: stands.x + 60, y: stands.y + 330 }
      // To the side first: up and down scrolls the list.
      const from = await child.middleOf(hit)
      const hand = finger(page)
      await hand.down(from)
      for (const way of [12, 30, 60]) await hand.move({ x: from.x + way, y: from.y })
      await expect(hands.field).toHaveCount(0)
      for (const share of [0.3, 0.6, 0.9, 1])
        await hand.move({
          x: from.x + 60 + (to.x - from.x - 60) * share,
          y: from.y + (to.y - from.y) * share,
        })
      await child.watches(3)
      await hand.up()
      await expect.poll(() => blocks.count()).toBeGreaterThan(before)
      const last = (await child.canvas.locator('> .blocklyDraggable').last().boundingBox())!
      expect(Math.abs(last.x + 18 - to.x)).toBeLessThan(30)
      expect(Math.abs(last.y + 12 - to.y)).toBeLessThan(30)
      await child.presses('lab.undo')
      await expect(blocks).toHaveCount(before)
      await expect(child.button('lab.undo')).toBeDisabled()
    })

    test('a tap puts it in below, and the list scrolls under a finger without losing a block', async ({
      child,
      page,
    }) => {
      const { hands, blocks, before } = await opensWaits(child)
      await hands.searches('e')
      const at = await child.middleOf(hands.hits.nth(3))
      await child.drags(at, { x: at.x, y: at.y - 120 })
      await expect(hands.field).toBeVisible()
      await expect(blocks).toHaveCount(before)
      await hands.field.fill(searched[language])
      const hit = await child.middleOf(hands.hits.first())
      await page.touchscreen.tap(hit.x, hit.y)
      await expect(hands.field).toHaveCount(0)
      await expect.poll(() => blocks.count()).toBeGreaterThan(before)
    })
  })
}

test.describe('where the pointer is a finger', () => {
  test.use({ isMobile: true })

  test('a number in a block is met 20 px above and below its middle', async ({ child, page }) => {
    await opensWaits(child)
    const field = child.canvas.locator('.blocklyNumberField').first()
    await expect.poll(async () => (await field.boundingBox())!.height).toBeGreaterThanOrEqual(24)
    const { x, y } = await child.middleOf(field)
    for (const at of [y - 20, y + 20]) {
      await page.touchscreen.tap(x, at)
      await expect(page.locator('.blocklyHtmlInput')).toBeVisible()
      await child.types('Escape')
      await expect(page.locator('.blocklyHtmlInput')).toHaveCount(0)
    }
  })
})
