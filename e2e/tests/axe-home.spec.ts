// Rooms: parts, home, network, app
// axe in every state of home and of a card in the lab. Building, robot, time and networks: axe-lab.
import type { Page } from '@playwright/test'
import { findsNothing, type States } from '../axe.ts'
import { opensSettings } from '../child-cards.ts'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensCard } from '../navigation.ts'
import { projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

const sizes = [
  { width: 1366, height: 768 },
  { width: 390, height: 844 },
]

/** Controls beside the screen, outside of everything that scrolls. */
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
      .map((one) => `beside the screen: ${one.textContent?.trim() || one.getAttribute('aria-label')}`),
  )

const pages: States = {
  home: (child) => child.opensHome(),
  'home, a name for an empty project': async (child) => {
    await child.page.getByRole('button', { name: child.word('home.free') }).click()
    await expect(child.page.getByLabel(child.word('projects.name'), { exact: true })).toBeFocused()
  },
  'home on the second visit': async (child) => {
    await child.opensLab('fear')
    await child.presses('lab.hint')
    await child.seesSaved()
    await child.opensHome()
    const goOn = child.word('home.continue', { name: child.card('fear') })
    await expect(child.page.getByRole('link', { name: goOn })).toBeVisible()
  },
  'settings at home': (child) => opensSettings(child, 'home'),
  'a card that is not there': async (child) => {
    // By address: a link that leads nowhere.
    await child.page.goto('/lab/nosuchcard')
    await expect(child.words('lab.unknownCardText')).toBeVisible()
  },
  'a page that is not there': async (child) => {
    // By address: a link that leads nowhere.
    await child.page.goto('/no/such/page')
    await expect(child.words('parts.lostText')).toBeVisible()
  },
}

/** Everything that the lab shows; on a phone one part at a time. */
const lab: States = {
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

/** With every setting switched on; the smaller size is a laptop at 200 %. */
const switchedOn: States = {
  home: (child) => child.opensHome(),
  lab: async (child) => {
    // At twice the size the blocks are a page of their own.
    await opensCard(child, 'chameleon')
    await expect(child.button('lab.start').first()).toBeVisible()
  },
  settings: (child) => opensSettings(child, 'lab'),
}

const twoSizes = (child: Child, states: States) => findsNothing(child, states, outOfSight)

for (const language of languagesOf(import.meta.filename)) {
  for (const size of sizes)
    test.describe(`at ${size.width} × ${size.height}, in ${language}`, () => {
      test.use({ language, viewport: size, complaints: [/status of 404/] })

      test('axe finds nothing on home and on pages that are not there', ({ child }) => twoSizes(child, pages))
      test('axe finds nothing in the lab, whatever is open', async ({ child }) => {
        test.setTimeout(300_000)
        await twoSizes(child, lab)
      })
    })

  for (const viewport of [
    { width: 1366, height: 768 },
    { width: 683, height: 384 },
  ])
    test.describe(`with every setting, at ${viewport.width} × ${viewport.height}, in ${language}`, () => {
      test.use({ language, viewport })
      test('axe finds nothing', async ({ child, page }) => {
        await page.addInitScript(() =>
          localStorage.setItem(
            'botgarten.comfort',
            '{"projector":true,"quiet":true,"letters":true,"aloud":true}',
          ),
        )
        await findsNothing(child, switchedOn)
      })
    })
}
