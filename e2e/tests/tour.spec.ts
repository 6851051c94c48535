// Rooms: tour
import type { Locator } from '@playwright/test'
import { node } from '../child-cards.ts'
import { leftWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensCard } from '../navigation.ts'
import { languagesOf } from '../words.ts'

const tour = ({ page, word }: { page: Child['page']; word: (key: string) => string }) =>
  page.getByRole('region', { name: word('tour.title'), exact: true })
const tourOf = (child: Child) => tour({ page: child.page, word: (key) => child.word(key) })
const motor = (child: Child) => child.word('neuron.motor', { OUTPUTNODE: leftWheel.motor })
const highlighted = (child: Child) => child.page.locator('.blocklyBlockCanvas .editor-highlight')
const wheel = 'bo motor C'

const phone = { width: 390, height: 844 }
/** A school laptop's 1366 × 768 at 200 %. */
const twice = { width: 683, height: 384 }

/** All of it is on the screen, and its middle is not covered by anything else. */
async function seesWhole(child: Child, thing: Locator) {
  await expect(thing).toBeInViewport({ ratio: 1 })
  await expect
    .poll(async () => {
      const { x, y } = await child.middleOf(thing)
      return thing.evaluate(
        (own, at) => {
          const top = document.elementFromPoint(at.x, at.y)
          // A drawing lies under the grip that takes it.
          return (
            top !== null &&
            (own.contains(top) || (own.closest('.grip, .blocklyDraggable')?.contains(top) ?? false))
          )
        },
        { x, y },
      )
    })
    .toBe(true)
}

/** A painted part of Bo is in sight, and nothing else covers it. */
async function seesPart(child: Child, name: string) {
  await expect
    .poll(async () => {
      const { x, y } = await child.painted.place(name)
      return child.page.evaluate((at) => document.elementFromPoint(at.x, at.y)?.closest('.world') !== null, {
        x,
        y,
      })
    })
    .toBe(true)
}

/** Block, node and part of Bo that light up now. */
async function lights(child: Child, block: string | null) {
  await expect(highlighted(child)).toHaveCount(block ? 1 : 0)
  if (block) await expect(highlighted(child)).toHaveAttribute('data-id', block)
  await expect.poll(() => child.painted.lit()).toHaveLength(block ? 2 : 0)
  if (block) await expect.poll(() => child.painted.lit()).toContain(`neuron ${block}`)
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`in ${language}`, () => {
    test.use({ language, motion: true })

    test('block, node and part of Bo light up together, whichever is touched', async ({ child, page }) => {
      await child.opensLab('friendship')
      await lights(child, null)
      await child
        .block('wheelLeft')
        .locator('.blocklyPath')
        .first()
        .hover({ position: { x: 8, y: 14 } })
      await lights(child, 'wheelLeft')
      await page.mouse.move(4, 300)
      await lights(child, null)
      await node(
        child,
        'showWhere',
        child.nameOf({ sensor: 'distance', port: '2', place: 'frontLeft' }),
      ).click()
      await page.mouse.move(4, 300)
      await lights(child, 'eyeLeft')
      await node(child, 'showSum', motor(child)).focus()
      await lights(child, 'wheelLeft')
      const { x, y } = await child.painted.place('bo motor B')
      await page.mouse.click(x, y)
      await page.mouse.move(4, 300)
      await lights(child, 'wheelRight')
    })

    test.describe('for a newcomer', () => {
      test.use({ newcomer: true })

      test('the tour is offered once, goes through three moves and comes again from the menu', async ({
        child,
        page,
      }) => {
        await page.emulateMedia({ reducedMotion: 'reduce' })
        await child.opensLab('friendship')
        await expect(tourOf(child)).toContainText(child.word('tour.offer'))
        await child.presses('tour.yes')
        await expect(tourOf(child)).toContainText(child.word('tour.block', { name: motor(child) }))
        await child
          .block('wheelLeft')
          .locator('.blocklyPath')
          .first()
          .click({ position: { x: 8, y: 14 } })
        await expect(tourOf(child)).toContainText(child.word('tour.litBlock'))
        await child.presses('tour.next')
        await node(child, 'showSum', motor(child)).click()
        await expect(tourOf(child)).toContainText(child.word('tour.litNode'))
        await child.presses('tour.next')
        const side = child.word('network.place.left')
        await expect(tourOf(child)).toContainText(child.word('tour.wheel', { side }))
        await lights(child, null)
        const { x, y } = await child.painted.place(wheel)
        await page.mouse.click(x, y)
        await expect(tourOf(child)).toContainText(child.word('tour.litWheel'))
        await child.presses('tour.done')
        await expect(tourOf(child)).toHaveCount(0)
        await child.reloads()
        await expect(tourOf(child)).toHaveCount(0)
        await child.presses('lab.menu')
        await child.presses('comfort.title')
        await child.presses('tour.again')
        await expect(tourOf(child)).toContainText(child.word('tour.step', { number: 1, of: 3 }))
      })

      test('it can be skipped, and done by keys alone', async ({ child, page }) => {
        await child.opensLab('fear')
        await child.tabsAndPresses('tour.yes')
        for (const said of ['litBlock', 'litNode', 'litWheel']) {
          await child.tabsAndPresses('tour.show')
          await expect(tourOf(child)).toContainText(child.word(`tour.${said}`))
          await child.tabsAndPresses(said === 'litWheel' ? 'tour.done' : 'tour.next')
        }
        await expect(tourOf(child)).toHaveCount(0)
        await page.evaluate(() => localStorage.removeItem('botgarten.tour'))
        await child.reloads()
        await child.presses('tour.no')
        await child.reloads()
        await expect(tourOf(child)).toHaveCount(0)
      })

      test('it never covers Bo, and goes on where it was when the window becomes small', async ({
        child,
        page,
      }) => {
        await child.opensLab('friendship')
        const panel = (await tourOf(child).boundingBox())!
        const bo = await child.middleOf(child.bo)
        expect(bo.x > panel.x + panel.width || bo.y < panel.y).toBe(true)
        await child.presses('tour.yes')
        await child.presses('tour.show')
        await child.presses('tour.next')
        await page.setViewportSize(phone)
        await expect(tourOf(child)).toContainText(child.word('tour.step', { number: 2, of: 3 }))
        await seesWhole(child, node(child, 'showSum', motor(child)))
      })

      for (const [name, size] of Object.entries({ 'a phone': phone, 'a laptop at 200 %': twice }))
        test(`on ${name} it turns the pages: what is to be tapped is in sight, nothing is covered`, async ({
          child,
          page,
        }) => {
          await page.setViewportSize(size)
          await page.emulateMedia({ reducedMotion: 'reduce' })
          await opensCard(child, 'friendship')
          await expect(tourOf(child)).toContainText(child.word('tour.offer'))
          await seesWhole(child, child.button('tour.yes'))
          await child.presses('tour.yes')
          const block = child.block('wheelLeft').locator('.blocklyPath').first()
          await seesWhole(child, block)
          await block.click({ position: { x: 8, y: 14 } })
          await expect(tourOf(child)).toContainText(child.word('tour.litBlockAlone'))
          await expect(highlighted(child)).toHaveAttribute('data-id', 'wheelLeft')
          await child.presses('tour.next')
          // The light has come along: node and wheel are seen lit side by side.
          await expect(tourOf(child)).toContainText(child.word('tour.nodeAlone', { name: motor(child) }))
          await expect.poll(() => child.painted.lit()).toHaveLength(2)
          await expect.poll(() => child.painted.lit()).toContain(wheel)
          await seesPart(child, wheel)
          await node(child, 'showSum', motor(child)).click()
          await expect(tourOf(child)).toContainText(child.word('tour.litNodeAlone'))
          await child.presses('tour.next')
          await expect.poll(() => child.painted.lit()).toEqual([])
          await seesPart(child, wheel)
          const { x, y } = await child.painted.place(wheel)
          await page.mouse.click(x, y)
          await expect(tourOf(child)).toContainText(child.word('tour.litWheel'))
          await child.presses('tour.done')
          await expect(tourOf(child)).toHaveCount(0)
          await expect(child.button('lab.start')).toBeVisible()
        })

      test('on a phone it is done by keys alone', async ({ child, page }) => {
        await page.setViewportSize(phone)
        await child.opensLab('fear')
        await child.tabsAndPresses('tour.yes')
        for (const said of ['litBlockAlone', 'litNodeAlone', 'litWheel']) {
          await expect(tourOf(child)).toBeFocused()
          await child.tabsAndPresses('tour.show')
          await expect(tourOf(child)).toContainText(child.word(`tour.${said}`))
          await child.tabsAndPresses(said === 'litWheel' ? 'tour.done' : 'tour.next')
        }
        await expect(tourOf(child)).toHaveCount(0)
        await child.presses('lab.menu')
        await child.presses('comfort.title')
        await child.presses('tour.again')
        await expect(tourOf(child)).toContainText(child.word('tour.step', { number: 1, of: 3 }))
        await seesWhole(child, child.block('wheelLeft').locator('.blocklyPath').first())
      })
    })
  })
}
