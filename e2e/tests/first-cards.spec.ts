// Rooms: content, app, editor, network, q-learning, sorting
import type { Locator } from '@playwright/test'
import { BlockHands } from '../child-blocks.ts'
import { colourInput, knobOf } from '../child-cards.ts'
import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/** Most words in the strip of the task, and most presses, drags and typed numbers up to the first goal. */
const most = { words: 40, actions: 4 }

/** The first card of each bed, and how a child reaches a goal there without a hint. */
const firstCards: { readonly [card: string]: (child: Child) => Promise<void> } = {
  chameleon: async (child) => {
    const lamp = child.word('neuron.lamp', { OUTPUTNODE: child.word('choice.green') })
    const knob = knobOf(child, colourInput(child, 'colour', 'green'), lamp)
    await knob.click()
    await child.types('1', 'Enter')
    await child.presses('lab.start')
  },
  mars: async (child) => {
    await child.presses('lab.unfold')
    await child
      .block('experience')
      .locator('.blocklyInputField')
      .filter({ hasText: /^\s*1\s*$/ })
      .click()
    await child.types('ControlOrMeta+a', '1', '0', '0', 'Enter')
    await child.presses('lab.start')
  },
  'tidy-up': async (child) => {
    const hands = new BlockHands(child)
    await child.press(hands.row('sorting'))
    const find = child.page.locator('.blocklyFlyout .ai_sorting_find').first()
    const [from, below] = [await corner(find), await corner(child.block('b11'))]
    await child.drags(from, below)
    await expect(child.page.locator('.blocklyDragging')).toHaveCount(0)
    await child.presses('lab.start')
  },
  forward: async (child) => {
    await child.typesNumber('driveDistance', '170')
    await child.presses('lab.start')
  },
}

async function corner(block: Locator) {
  await expect(block).toBeVisible()
  const { x, y } = (await block.boundingBox())!
  return { x: x + 8, y: y + 12 }
}

for (const language of languagesOf(import.meta.filename))
  for (const [card, solves] of Object.entries(firstCards))
    test.describe(`${card} in ${language}`, () => {
      test.use({ language })

      test('reaches its first goal in four actions, with forty words to read', async ({ child, page }) => {
        await child.opensLab(card)
        const strip = page.locator('.task-strip')
        await expect(strip.locator('.task')).toBeVisible()
        const words = (await strip.innerText()).match(/[\p{L}\p{N}]+/gu) ?? []
        expect(words.length, words.join(' ')).toBeLessThanOrEqual(most.words)
        await page.evaluate(() => {
          const counted = Object.assign(globalThis, { actions: 0 })
          addEventListener('pointerdown', () => (counted.actions += 1), true)
          // A number that was typed.
          addEventListener('keydown', ({ key }) => (counted.actions += key === 'Enter' ? 1 : 0), true)
        })
        await solves(child)
        const actions = await page.evaluate(() => (globalThis as unknown as { actions: number }).actions)
        expect(actions).toBeLessThanOrEqual(most.actions)
        const time = new TimeHands(child)
        if (card === 'mars') {
          const learner = new Learner(child)
          await learner.hurries()
          await learner.seesEnd()
          await time.opens()
        }
        await time.hurries()
        await expect(
          page.locator('.task-strip').getByText(child.word('lab.goalPassed')).first(),
        ).toBeAttached()
      })
    })
