// Rooms: lab, editor
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** Where the square is said to be, in cm. */
const squareAt = async (child: Child) =>
  (await child.thing('block').getAttribute('aria-label'))?.match(/\d+/g)

/** What a child has changed so far, one of each kind. */
const state = async (child: Child) => ({
  knobs: await child.knobs.count(),
  left: await child.knob(leftEye, leftWheel).getAttribute('aria-valuenow'),
  square: await squareAt(child),
  right: await child.knob(rightEye, rightWheel).getAttribute('aria-valuenow'),
  blocks: await child.blockWords(),
})

/** Four changes: the blocks, a knob, a moved thing, and a knob again. Returns what there was to see in between. */
async function changesFourThings(child: Child) {
  await child.seesBlocks()
  const states = [await state(child)]
  await child.addsNeuron('addMotor')
  await expect(child.knobs).toHaveCount(6)
  states.push(await state(child))
  await child.dragsKnob(leftEye, leftWheel, 0.5)
  states.push(await state(child))
  await child.dragsThing('block', { x: 40, y: -60 })
  states.push(await state(child))
  await child.typesWeight(rightEye, rightWheel, 0.25)
  states.push(await state(child))
  return states
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`undo and redo, in ${language}`, () => {
    test.use({ language })

    test('go step by step over blocks, knobs and the world, in order', async ({ child }) => {
      await child.opensLab('friendship')
      const states = await changesFourThings(child)
      expect(new Set(states.map((one) => JSON.stringify(one))).size, 'each change is to be seen').toBe(5)

      for (const before of states.slice(0, -1).toReversed()) {
        await child.presses('lab.undo')
        await expect.poll(() => state(child)).toEqual(before)
      }
      await expect(child.button('lab.undo')).toHaveAttribute('aria-disabled', 'true')
      for (const after of states.slice(1)) {
        await child.presses('lab.redo')
        await expect.poll(() => state(child)).toEqual(after)
      }
      await expect(child.button('lab.redo')).toHaveAttribute('aria-disabled', 'true')
      await child.seesSaved()
      await child.reloads()
      await expect.poll(() => state(child)).toEqual(states.at(-1))
    })
  })
}

test('the keyboard takes back and goes on again, wherever the focus is; a new change ends what could come again', async ({
  child,
}) => {
  await child.opensLab('friendship')
  const states = await changesFourThings(child)
  await child.types('Control+z', 'Control+z')
  await expect.poll(() => state(child)).toEqual(states[2])
  await child.thing('block').focus()
  await child.types('Control+z')
  await expect.poll(() => state(child)).toEqual(states[1])
  await child.block('net').click({ position: { x: 40, y: 12 } })
  await child.types('Control+z')
  await expect.poll(() => state(child)).toEqual(states[0])
  await child.types('Control+Shift+z', 'Control+y')
  await expect.poll(() => state(child)).toEqual(states[2])
  await child.typesWeight(rightEye, leftWheel, 0.1)
  await expect(child.button('lab.redo')).toHaveAttribute('aria-disabled', 'true')
})

test('weights of a neuron that was taken away come back with it', async ({ child }) => {
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.8)
  await child.block('eyeLeft').click({ position: { x: 30, y: 10 } })
  await child.types('Delete')
  await expect(child.knobs).toHaveCount(2)
  await child.presses('lab.undo')
  await expect(child.knobs).toHaveCount(4)
  await child.seesWeight(leftEye, leftWheel, 0.8)
})

test('a step that is taken back before Blockly has told of it can come again', async ({ child, page }) => {
  await child.opensLab('friendship')
  const words = await child.blockWords()
  await child.block('eyeLeft').click({ position: { x: 30, y: 10 } })
  await page.evaluate(() => {
    const press = (init: KeyboardEventInit) =>
      document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { bubbles: true, ...init }))
    press({ key: 'Delete', keyCode: 46 })
    press({ key: 'z', keyCode: 90, ctrlKey: true })
  })
  await expect(child.button('lab.redo')).toBeEnabled()
  await expect(child.knobs).toHaveCount(4)
  await expect.poll(() => child.blockWords()).toEqual(words)
  await child.types('Control+y')
  await expect(child.knobs).toHaveCount(2)
})
