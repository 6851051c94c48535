// Rooms: app, network
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/** Takes the lamp block from the shelf and puts it behind the network, by Blockly's own keys. */
async function putsALampIntoTheLoop(child: Child) {
  const shelf = (category: string) =>
    child.page.getByRole('treeitem', { name: child.word(`category.${category}`), exact: true })
  await child.tabsTo(shelf('control'))
  await child.types('ArrowDown')
  await expect(shelf('action')).toBeFocused()
  await child.types('ArrowRight')
  const lamp = child.page.getByRole('option', {
    name: new RegExp(`^${child.word('block.actions_bricklight_on_ev3.name').split(' ')[0]},`),
  })
  for (
    let presses = 0;
    presses < 12 && !(await lamp.first().evaluate((one) => one === document.activeElement));
    presses += 1
  )
    await child.types('ArrowDown')
  await expect(lamp.first()).toBeFocused()
  await child.types('Enter')
  for (let presses = 0; presses < 8 && !(await isBehindTheNetwork(child)); presses += 1)
    await child.types('ArrowDown')
  await child.types('Enter')
}

/** The lamp is a child of the network's own row: Blockly hangs what follows a block into it. */
const lampBehindTheNetwork = (child: Child) => child.block('net').locator('.actions_bricklight_on_ev3')
const isBehindTheNetwork = async (child: Child) => (await lampBehindTheNetwork(child).count()) > 0

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child with nothing but keys, in ${language}`, () => {
    test.use({ language })

    test('goes the whole way from home to a robot that finds friends', async ({ child, page }) => {
      test.setTimeout(240_000)

      await test.step('home', async () => {
        await child.opensHome()
        await child.tabsTo(page.getByRole('link', { name: child.card('friendship'), exact: true }))
        await child.types('Enter')
        await child.seesLab()
      })

      await test.step('a block from the shelf, taken back and put in again', async () => {
        const words = await child.blockWords()
        await putsALampIntoTheLoop(child)
        await expect(lampBehindTheNetwork(child)).toBeVisible()
        await child.types('Control+z')
        await expect(lampBehindTheNetwork(child)).toBeHidden()
        await expect.poll(() => child.blockWords()).toEqual(words)
        await child.types('Control+y')
        await expect(lampBehindTheNetwork(child)).toBeVisible()
      })

      await test.step('start, pause, two knobs, on', async () => {
        await child.tabsAndPresses('lab.start')
        await child.tabsAndPresses('lab.pause')
        await child.tabsTo(child.knob(leftEye, leftWheel))
        await child.types(...(0.8).toLocaleString(language), 'Enter')
        await child.tabsTo(child.knob(rightEye, rightWheel))
        await child.types('End', 'Shift+ArrowDown')
        await child.seesWeight(leftEye, leftWheel, 0.8)
        await child.seesWeight(rightEye, rightWheel, 0.8)
        await child.tabsAndPresses('lab.continue')
        await child.seesDriving()
        await new TimeHands(child).hurriesByKeys()
      })

      await test.step('all goals are green; on from the next place', async () => {
        for (const goal of ['near', 'neverTouches', 'stays']) await child.seesCheck('friendship', goal)
        await child.tabsAndPresses('lab.successStart', { number: 2 })
        // At this speed Bo may have passed it by now.
        const second = child
          .button('lab.place', { number: 2 })
          .or(child.button('lab.placePassed', { number: 2 }))
        await expect(second).toHaveAttribute('aria-pressed', 'true')
        await expect(child.button('lab.placePassed', { number: 1 })).toBeVisible()
      })

      await test.step('a project file, and home', async () => {
        await child.tabsAndPresses('lab.menu')
        await child.tabsTo(child.button('lab.saveFile'))
        const [download] = await Promise.all([page.waitForEvent('download'), child.types('Enter')])
        expect(download.suggestedFilename()).toBe(`${child.card('friendship')}.botgarten.json`)
        await child.tabsTo(page.getByRole('link', { name: child.word('parts.home') }))
        await child.types('Enter')
        await child.seesTitle()
      })
    })
  })
}

test('dialogs, hints and menus open, close and give the focus back by keys', async ({ child, page }) => {
  await child.opensLab('friendship')
  await child.tabsAndPresses('lab.card')
  await expect(page.getByRole('dialog')).toBeVisible()
  for (let presses = 0; presses < 4; presses += 1) {
    await child.types('Tab')
    const outside = await page.evaluate(
      () =>
        document.activeElement!.closest('dialog') === null &&
        document.hasFocus() &&
        document.activeElement !== document.body,
    )
    expect(outside, 'the focus stays in the dialog').toBe(false)
  }
  await child.types('Escape')
  await expect(page.getByRole('dialog')).toBeHidden()
  await expect(child.button('lab.card')).toBeFocused()

  await child.tabsAndPresses('lab.menu')
  await expect(child.button('lab.saveFile')).toBeVisible()
  await child.types('Escape')
  await expect(child.button('lab.saveFile')).toBeHidden()
  await expect(child.button('lab.menu')).toBeFocused()

  await child.tabsAndPresses('lab.hint')
  const hint = page.getByRole('region', { name: child.word('lab.hint') })
  await expect(hint).toBeFocused()
  await child.tabsAndPresses('lab.hintNext')
  await expect(hint).toContainText(child.word('lab.hintTitle', { number: 2, of: 3 }))
  await child.tabsTo(hint.getByRole('button', { name: child.word('parts.close') }))
  await child.types('Enter')
  await expect(hint).toBeHidden()
  await expect(child.button('lab.hint')).toBeFocused()
})

test('arrow keys drive Bo, move and turn things, and move the borders of panes', async ({ child, page }) => {
  await child.opensLab('friendship')
  await child.tabsTo(page.getByRole('application', { name: child.word('world.label') }))
  await page.keyboard.down('ArrowUp')
  await child.seesDriving()
  await page.keyboard.up('ArrowUp')
  await child.watches(5)
  await child.seesStanding()

  const square = child.thing('block')
  await child.tabsTo(square)
  const at = async () =>
    (await square.getAttribute('aria-label'))!.match(/\d+/g)!.map(Number) as [number, number]
  const [x, y] = await at()
  await child.types('ArrowRight', 'ArrowRight', 'Shift+ArrowUp')
  await expect.poll(at).toEqual([x + 2, y + 10])
  await child.types('Enter')
  const turning = page.getByRole('slider', {
    name: child.word('world.turn', { thing: child.word('world.thing.block') }),
  })
  await child.tabsTo(turning)
  await child.types('ArrowLeft', 'ArrowLeft')
  await expect(turning).toHaveAttribute('aria-valuenow', '10')

  const border = page.getByRole('separator', { name: child.word('lab.borderProgram') })
  await child.tabsTo(border)
  const before = Number(await border.getAttribute('aria-valuenow'))
  await child.types('ArrowRight')
  await expect.poll(async () => Number(await border.getAttribute('aria-valuenow'))).toBeGreaterThan(before)
})
