// Rooms: content, world
import type { Page } from '@playwright/test'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

test.use({ motion: true })

/** Bo drives towards the square. */
async function drivesOff(child: Child) {
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.5)
  await child.typesWeight(rightEye, rightWheel, 0.5)
  await child.pressesStart()
  await child.seesDriving()
}

/** A headless page is always in sight: it is told that it is not, and when it is again. */
async function hides(page: Page, hidden: boolean) {
  await page.evaluate((isHidden) => {
    Object.defineProperty(document, 'hidden', { configurable: true, value: isHidden })
    Object.defineProperty(document, 'visibilityState', {
      configurable: true,
      value: isHidden ? 'hidden' : 'visible',
    })
    document.dispatchEvent(new Event('visibilitychange'))
  }, hidden)
}

/** Movements that the browser carries out by itself at this moment. */
const movements = (child: Child) =>
  child.page.evaluate(
    () => document.getAnimations().filter(({ playState }) => playState === 'running').length,
  )

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('sets knobs, and no other knob moves away when the sum below gets longer', async ({ child }) => {
      await child.opensLab('fear')
      const other = child.knob(rightEye, leftWheel)
      const before = await child.middleOf(other)
      await child.typesWeight(leftEye, rightWheel, 0.85)
      await child.typesWeight(rightEye, rightWheel, 0.55)
      const after = await child.middleOf(other)
      expect(after.x).toBeCloseTo(before.x, 0)
      expect(after.y).toBeCloseTo(before.y, 0)
    })

    test('drops the square on Bo while Bo drives: they stand side by side, and the square goes back by undo', async ({
      child,
      page,
    }) => {
      await drivesOff(child)
      const before = await child.thing('block').getAttribute('aria-label')
      const [square, bo] = [await child.middleOf(child.thing('block')), await child.middleOf(child.bo)]
      await child.drags(square, bo)
      await expect(child.thing('block')).not.toHaveAttribute('aria-label', before!)
      await child.presses('lab.pause')
      const [ground, robot] = [await child.thing('block').boundingBox(), await child.middleOf(child.bo)]
      const inside = (at: number, from: number, length: number) => at > from && at < from + length
      expect(
        inside(robot.x, ground!.x, ground!.width) && inside(robot.y, ground!.y, ground!.height),
        'nothing stands on Bo',
      ).toBe(false)
      await child.presses('lab.undo')
      await expect(child.thing('block')).toHaveAttribute('aria-label', before!)
      await child.presses('lab.continue')
      await child.seesDriving()
      expect(page.url()).toContain('/lab/friendship')
    })

    test('goes to another tab: Bo waits, and that is said on return', async ({ child, page }) => {
      await drivesOff(child)
      await hides(page, true)
      await child.seesStanding()
      await hides(page, false)
      await expect(child.words('session.away')).toBeVisible()
      await child.seesStanding()
      await child.presses('lab.continue')
      await child.seesDriving()
    })

    test('changes the language while Bo drives: Bo drives on, and undo still holds every step', async ({
      child,
    }) => {
      await drivesOff(child)
      await child.addsNeuron('addMotor')
      await expect(child.knobs).toHaveCount(6)
      const other = language === 'de' ? 'en' : 'de'
      await child.speaks(other)
      await expect(child.button('lab.stop')).toBeVisible()
      await child.seesDriving()
      await expect(child.page.locator('html')).toHaveAttribute('lang', other)
      await expect.poll(() => child.blockWords()).toContain(child.word('block.ai_easy_list.addInput'))
      await child.presses('lab.undo')
      await expect(child.knobs).toHaveCount(4)
      await child.presses('lab.undo')
      await child.seesWeight(rightEye, rightWheel, 0)
      await child.presses('lab.undo')
      await child.seesWeight(leftEye, leftWheel, 0)
      await child.presses('lab.redo')
      await child.seesWeight(leftEye, leftWheel, 0.5)
      await child.reloads()
      await expect(child.button('lab.start')).toBeVisible()
    })
  })
}

test('Escape stops Bo, wherever the focus is', async ({ child }) => {
  await drivesOff(child)
  const places = [child.bo, child.knob(leftEye, leftWheel), child.button('lab.hint'), child.thing('block')]
  for (const place of places) {
    await place.focus()
    await child.types('Escape')
    await expect(child.button('lab.start')).toBeVisible()
    await child.seesStanding()
    await child.pressesStart()
    await child.seesDriving()
  }
  await child.block('net').click({ position: { x: 40, y: 12 } })
  await child.types('Escape')
  await expect(child.button('lab.start')).toBeVisible()
})

test('who wants little motion gets none: no pulses, nothing that moves by itself', async ({
  child,
  page,
}) => {
  const signals = async () => (await child.painted.places()).filter(({ name }) => name === 'pulse').length
  await drivesOff(child)
  await expect.poll(signals, 'signals travel').toBeGreaterThan(0)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await expect.poll(signals).toBe(0)
  await expect.poll(() => movements(child)).toBe(0)
  await child.seesDriving()
  for (const path of ['/', '/lab/fear']) {
    // By address: the first load of a page must not move either.
    await page.goto(path)
    await child.seesTitle()
    await child.watches(10)
    expect(await movements(child), path).toBe(0)
  }
})
