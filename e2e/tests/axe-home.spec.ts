// Rooms: parts, home, network
import type { Page } from '@playwright/test'
import { axeFindings } from '../axe.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 390, height: 844 },
]

/** Half-way through a fade colours are not what they will be. */
const settles = (page: Page) =>
  page.evaluate(async () => {
    const ending = document
      .getAnimations()
      .filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity)
    await Promise.allSettled(ending.map(({ finished }) => finished))
  })

/** What can be pressed and lies beside the screen, outside of everything that scrolls. */
const outOfSight = (page: Page) =>
  page.locator('button:visible, a:visible, select:visible').evaluateAll((all) =>
    all
      .filter((one) => {
        const { left, right, width } = one.getBoundingClientRect()
        // Things of the world lie where the world is.
        if (one.closest('.world') || width <= 1 || (left > -1 && right < innerWidth + 1)) return false
        for (let box = one.parentElement; box; box = box.parentElement)
          if (/auto|scroll/.test(getComputedStyle(box).overflowX) && box !== document.body) return false
        return true
      })
      .map((one) => one.textContent?.trim() || one.getAttribute('aria-label')),
  )

/**
 * Nothing is left out, Blockly included: what axe has to say about Blockly 13 as it comes (`aria-owns` with ids that are no
 * names, a list box without a name) is gone with plain ids and names for the list.
 */
async function findsNothing(page: Page, where: string) {
  await settles(page)
  expect(await outOfSight(page), where).toEqual([])
  expect(await axeFindings(page), where).toEqual([])
}

/** Ways to every face that the lab shows; on a phone one part at a time. */
const faces: { readonly [name: string]: (child: Child, phone: boolean) => Promise<unknown> } = {
  stopped: (child) => child.opensLab('friendship'),
  program: async (child, phone) => phone && (await child.turnsTo('program')),
  network: async (child, phone) => phone && (await child.turnsTo('networkTab')),
  'settings of the network': async (child) => {
    await child.presses('network.settings')
    await expect(child.words('net.levels.expert')).toBeVisible()
  },
  'with weights, running': async (child, phone) => {
    await child.types('Escape')
    await child.typesWeight(leftEye, leftWheel, 0.8)
    await child.typesWeight(rightEye, rightWheel, 0.3)
    if (phone) await child.turnsTo('world')
    await child.pressesStart()
    await child.seesDriving()
  },
  paused: async (child) => child.presses('lab.pause'),
  'with a thing in the hand': async (child) => {
    await child.bo.focus()
    await child.types('Enter')
    await expect(
      child.page.getByRole('slider', { name: child.word('world.turn', { thing: 'Bo' }) }),
    ).toBeVisible()
  },
  'hint open': async (child) => {
    await child.presses('lab.hint')
    await child.presses('lab.hintNext')
  },
  'menu open': async (child) => child.presses('lab.menu'),
  'card open': async (child) => {
    await child.types('Escape')
    await child.presses('lab.card')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'a file refused': async (child) => {
    await child.types('Escape')
    await child.opensFile('newer.json', '{"botgarten":7}')
    await expect(child.dialog('problem.newerVersion.title')).toBeVisible()
  },
  'a block needs help': async (child, phone) => {
    await child.types('Escape')
    const broken = projectFile('friendship', 'start').replace('ULTRASONIC_PORT_2', 'ULTRASONIC_PORT_4')
    await child.opensFile('broken.json', broken)
    await expect(child.words('session.needsHelp')).toBeVisible()
    if (phone) await child.turnsTo('program')
    const facts = { port: '4', other: '2' }
    await expect(child.words('problem.noDistanceSensorEmpty.title', facts)).toBeVisible()
  },
}

for (const language of languagesOf(import.meta.filename))
  for (const size of sizes)
    test.describe(`at ${size.width} × ${size.height}, in ${language}`, () => {
      test.use({ language, viewport: size, complaints: [/status of 404/] })

      test('axe finds nothing on home and on pages that are not there', async ({ child, page }) => {
        await child.opensHome()
        await findsNothing(page, 'home')
        await child.opensLab('fear')
        await child.presses('lab.hint')
        await child.seesSaved()
        await child.opensHome()
        await expect(
          page.getByRole('link', { name: child.word('home.continue', { name: child.card('fear') }) }),
        ).toBeVisible()
        await findsNothing(page, 'home on the second visit')
        // By address: links that lead nowhere.
        await page.goto('/lab/nosuchcard')
        await expect(child.words('lab.unknownCardText')).toBeVisible()
        await findsNothing(page, 'a card that is not there')
        // By address: links that lead nowhere.
        await page.goto('/no/such/page')
        await expect(child.words('parts.lostText')).toBeVisible()
        await findsNothing(page, 'a page that is not there')
      })

      test('axe finds nothing in the lab, whatever is open', async ({ child, page }) => {
        test.setTimeout(300_000)
        for (const [face, show] of Object.entries(faces))
          await test.step(face, async () => {
            await show(child, size.width < 640)
            await findsNothing(page, face)
          })
      })
    })
