// Rooms: class, editor
import { BlockHands } from '../child-blocks.ts'
import { TogetherHands } from '../child-together.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// A request through a pulled cable fails, and a browser complains of it.
test.use({ complaints: [/net::ERR_/] })

test('two children on one program, one with a pulled cable: both end with the same, and each keeps a copy', async ({
  browser,
  child: fox,
  context,
  contextOptions,
  house,
  page,
  school,
}) => {
  // One at a laptop in English, one with a finger on a tablet in German.
  const tablet = { viewport: { width: 1024, height: 768 }, hasTouch: true, locale: 'de-DE' }
  const second = await browser.newContext({ ...contextOptions, baseURL: house, ...tablet })
  await second.addInitScript(() => localStorage.setItem('botgarten.tour', '"seen"'))
  const owl = new Child(await second.newPage(), 'de', 'finger')
  await signsIn(page, school, await joins(school, 'Fuchs'))
  await signsIn(owl.page, school, await joins(school, 'Eule'))
  const [one, two] = [new TogetherHands(fox, school), new TogetherHands(owl, school)]

  await test.step('by keys one asks, by a finger the other accepts', async () => {
    await owl.opensHome()
    await fox.opensLab('friendship')
    await one.asks('Eule')
    // What is done until the other one has answered is there for both.
    await fox.typesWeight(rightEye, leftWheel, 0.1)
    await two.accepts()
    await one.seesBar()
    await one.isThe('hand')
    await two.isThe('eye')
    await owl.seesWeight(rightEye, leftWheel, 0.1)
  })
  await test.step('what one does the other sees, and where its hand is', async () => {
    await fox.typesWeight(leftEye, leftWheel, 0.4)
    await owl.seesWeight(leftEye, leftWheel, 0.4)
    await owl.dragsKnob(rightEye, rightWheel, 0.3)
    await fox.seesWeight(rightEye, rightWheel, 0.3)
    await owl.canvas
      .locator('.blocklyDraggable')
      .nth(1)
      .tap({ position: { x: 12, y: 12 } })
    await expect(one.handOf('Eule')).toBeVisible()
    await expect(one.chosen).toBeVisible()
  })
  await test.step('they swap: the eye is the hand', async () => {
    await owl.button('class.togetherSwap').tap()
    await one.isThe('eye')
    await two.isThe('hand')
  })
  await test.step('a knob turns while Bo drives', async () => {
    await fox.pressesStart()
    await owl.typesWeight(leftEye, leftWheel, 0.5)
    await fox.seesWeight(leftEye, leftWheel, 0.5)
    await expect(fox.button('lab.stop').first()).toBeVisible()
    await fox.pressesStop()
  })
  await test.step('both go on while the cable is out, and then have both', async () => {
    const before = await one.blocks()
    await context.setOffline(true)
    await fox.typesWeight(rightEye, rightWheel, 0.7)
    await one.seesAway()
    const id = (await owl.canvas.locator('.blocklyDraggable').nth(1).getAttribute('data-id'))!
    await new BlockHands(owl).chooses(id, 'DUPLICATE_BLOCK')
    await expect.poll(async () => (await two.blocks()).length).toBeGreaterThan(before.length)
    await owl.typesWeight(leftEye, rightWheel, 0.2)
    await context.setOffline(false)
    await fox.seesWeight(leftEye, rightWheel, 0.2)
    await owl.seesWeight(rightEye, rightWheel, 0.7)
    await expect.poll(() => one.blocks()).toEqual(await two.blocks())
    await expect.poll(async () => (await one.blocks()).length).toBeGreaterThan(before.length)
  })
  await test.step('undo takes back only the own steps', async () => {
    await fox.presses('lab.undo')
    await owl.seesWeight(rightEye, rightWheel, 0.3)
    await fox.seesWeight(leftEye, rightWheel, 0.2)
  })
  await test.step('what was done just before and after the page was loaded again is not lost', async () => {
    await fox.typesWeight(rightEye, rightWheel, 0.8)
    await fox.reloads()
    await fox.typesWeight(leftEye, leftWheel, 0.9)
    await one.seesBar()
    await owl.seesWeight(rightEye, rightWheel, 0.8)
    await owl.seesWeight(leftEye, leftWheel, 0.9)
    await fox.seesWeight(rightEye, rightWheel, 0.8)
  })
  await test.step('one leaves: both keep it', async () => {
    await one.seesSame()
    await two.seesSame()
    const blocks = await one.blocks()
    await one.leaves()
    await expect(two.bar).toContainText(owl.word('class.togetherOver', { name: 'Fuchs' }))
    await owl.presses('parts.ok')
    await expect(two.bar).toHaveCount(0)
    for (const hands of [one, two]) {
      await hands.child.reloads()
      await expect.poll(() => hands.blocks()).toEqual(blocks)
      await hands.child.seesWeight(leftEye, rightWheel, 0.2)
    }
  })
  await second.close()
})
