// Rooms: content, network
import type { Locator } from '@playwright/test'
import { colourInput, setsKnob } from '../child-cards.ts'
import type { Child } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { fitOf } from '../lab-fit.ts'
import { languagesOf } from '../words.ts'

const sees = (child: Child, colour: string) => colourInput(child, 'colour', colour)
const lamp = (child: Child, colour: string) =>
  child.word('neuron.lamp', { OUTPUTNODE: child.word(`choice.${colour}`) })

test('all three leaves are in view as the card opens', async ({ child, page }) => {
  await child.opensLab('chameleon')
  /** Of Bo, and of the middle of the red leaf, in cm from the left. */
  const [start, red] = [20, 164]
  const middle = async () => {
    const [bo, track] = [await child.painted.place('bo'), await child.painted.wheelsApart()]
    return bo.x + ((red - start) * track) / 18
  }
  const pane = (await page.getByRole('application', { name: child.word('world.label') }).boundingBox())!
  await expect.poll(middle).toBeLessThan(pane.x + pane.width)
})

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language })

    test('one knob lights the lamp on the green leaf, and on no other', async ({ child }) => {
      await child.opensLab('chameleon')
      await child.pressesStart()
      await setsKnob(child, sees(child, 'green'), lamp(child, 'green'), '1')
      await child.seesCheck('chameleon', 'green')
      await child.seesCheck('chameleon', 'yellow', false)
      await child.seesCheck('chameleon', 'red', false)
    })

    test('blocks that grow stay in sight: every plus stands above the scroll bar, and nothing is cut off', async ({
      child,
      page,
    }) => {
      await child.opensLab('chameleon')
      const box = async (thing: Locator) => (await thing.boundingBox())!
      const bar = page.locator('.blocklyMainWorkspaceScrollbar.blocklyScrollbarHorizontal')
      for (const list of ['inputs', 'inputs', 'inputs', 'outputs', 'outputs', 'outputs']) {
        const plus = child.block(list).locator('.editor-plus').first()
        const lines = child.block(list).locator('.blocklyDraggable')
        const count = await lines.count()
        await plus.click()
        await expect(lines).toHaveCount(count + 1)
        await expect
          .poll(async () => {
            const { y, height } = await box(plus)
            const { cut } = await fitOf(page)
            return { above: y + height <= (await box(bar)).y, below: y > (await box(lines.last())).y, cut }
          })
          .toEqual({ above: true, below: true, cut: 0 })
      }
    })

    test('a net that grows lights up on all three leaves', async ({ child, page }) => {
      await child.opensLab('chameleon')
      const colours = ['green', 'yellow', 'red']
      for (const colour of ['yellow', 'red'])
        await child.addsNeuron('addSensor', colourInput(child, 'colour', colour))
      for (const colour of ['orange', 'red']) await child.addsNeuron('addOutput', lamp(child, colour))
      await expect(child.knobs).toHaveCount(9)
      for (const [from, to] of [
        ['green', 'green'],
        ['yellow', 'orange'],
        ['red', 'red'],
      ] as const)
        await setsKnob(child, sees(child, from), lamp(child, to), '1')
      await child.pressesStart()
      await new TimeHands(child).hurries()
      for (const colour of colours) await child.seesCheck('chameleon', colour, true, 60_000)
      await expect(page.getByText(child.word('lab.successTitle')).first()).toBeVisible()
    })
  })
}
