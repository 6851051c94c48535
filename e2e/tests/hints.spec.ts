// Rooms: app, editor, q-learning
import { content } from '@botgarten/content/files'
import { colourInput, setsKnob } from '../child-cards.ts'
import { Learner } from '../child-learning.ts'
import { TimeHands } from '../child-time.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { sampled } from '../variant.ts'

// German words are the longest.
test.use({ language: 'de' })

const sizes = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]

const hintOf = (child: Child) => child.page.getByRole('region', { name: child.word('lab.hint'), exact: true })

/** Px by which the hint is cut off, or overlaps the lab below the strip of the task. */
const covers = (child: Child) =>
  hintOf(child).evaluate((hint) => {
    const { top, bottom } = hint.getBoundingClientRect()
    const head = document.querySelector('.lab > header')!.getBoundingClientRect()
    const panes = document.querySelector('.panes')!.getBoundingClientRect()
    return Math.round(
      Math.max(0, bottom - panes.top, head.bottom - top, hint.scrollHeight - hint.clientHeight),
    )
  })

test('a hint of any card covers nothing of the lab, in windows of any size', async ({ child, page }) => {
  test.slow()
  for (const [turn, { id }] of sampled(content.cards).entries()) {
    await page.setViewportSize(sizes[turn % 3]!)
    await child.opensLab(id)
    await child.presses('lab.hint')
    for (const size of sizes) {
      await page.setViewportSize(size)
      const found = async () => ({ id, width: size.width, covers: await covers(child) })
      await expect.poll(found).toEqual({ id, width: size.width, covers: 0 })
    }
  }
})

test('Escape closes a hint wherever the focus is, also among the blocks', async ({ child, page }) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  for (const place of [child.button('lab.hint'), learner.station(0), child.button('lab.start').first()]) {
    await child.presses('lab.hint')
    await expect(hintOf(child)).toBeVisible()
    await place.focus()
    await child.types('Escape')
    await expect(hintOf(child)).toHaveCount(0)
  }
  await child.opensLab('friendship')
  await child.presses('lab.hint')
  await page.locator('.program .blocklyBlockCanvas .blocklyPath').first().press('ArrowDown')
  await child.types('Escape')
  await expect(hintOf(child)).toHaveCount(0)
})

test('a hint goes once the card is solved, and does not come back', async ({ child, page }) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await child.presses('lab.hint')
  await learner.closes(2, 3)
  await expect(hintOf(child)).toBeVisible()
  await learner.hurries()
  await child.presses('lab.start')
  await child.seesDriving()
  const time = new TimeHands(child)
  await time.opens()
  await time.chooses('Infinity')
  await expect(page.getByText(child.word('lab.successTitle'), { exact: true })).toBeVisible()
  await expect(hintOf(child)).toHaveCount(0)
  await page
    .getByRole('status')
    .getByRole('button', { name: child.word('parts.close') })
    .click()
  await expect(hintOf(child)).toHaveCount(0)
})

test('after a run that missed something the next hint is due', async ({ child }) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await child.presses('lab.hint')
  const title = (number: number) => hintOf(child).getByText(child.word('lab.hintTitle', { number, of: 3 }))
  await expect(title(1)).toBeVisible()
  await child.types('Escape')
  await child.presses('lab.hint')
  await expect(title(1)).toBeVisible()
  await child.types('Escape')
  await learner.hurries()
  await child.presses('lab.start')
  await child.seesDriving()
  await child.pressesStop()
  await expect(child.button('lab.hint')).toHaveAttribute('data-offered')
  await child.presses('lab.hint')
  await expect(title(2)).toBeVisible()
})

test('a hint that was followed gives way to the next one when it is opened again', async ({ child }) => {
  await child.opensLab('chameleon')
  const title = (number: number) => hintOf(child).getByText(child.word('lab.hintTitle', { number, of: 3 }))
  const green = colourInput(child, 'colour', 'green')
  const lamp = child.word('neuron.lamp', { OUTPUTNODE: child.word('choice.green') })
  await child.presses('lab.hint')
  await expect(title(1)).toBeVisible()
  await setsKnob(child, green, lamp, '1')
  // It stays while it is open: its question can be answered first.
  await child.watches(10)
  await expect(title(1)).toBeVisible()
  await child.types('Escape')
  await child.presses('lab.hint')
  await expect(title(2)).toBeVisible()
  await child.types('Escape')
  for (const layer of ['addSensor', 'addOutput'] as const) await child.addsNeuron(layer)
  // The last hint has the numbers: not before a run.
  await child.presses('lab.hint')
  await expect(title(2)).toBeVisible()
  await child.types('Escape')
  await child.pressesStart()
  await child.pressesStop()
  await child.presses('lab.hint')
  await expect(title(3)).toBeVisible()
})
