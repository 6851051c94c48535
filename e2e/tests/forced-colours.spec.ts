// Rooms: parts
import type { Locator } from '@playwright/test'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { SortingHands } from '../child-sorting.ts'
import { expect, test } from '../house.ts'

test.use({ contextOptions: { forcedColors: 'active', reducedMotion: 'reduce' } })

/** What is painted that a high-contrast theme leaves: ground, border, ring. */
const painted = (thing: Locator) =>
  thing.evaluate((element) => {
    const { backgroundColor, borderColor, boxShadow } = getComputedStyle(element)
    return { backgroundColor, borderColor, boxShadow }
  })

/** The theme's colour for what is chosen. */
const highlight = (thing: Locator) =>
  thing.evaluate((element) => {
    const probe = element.ownerDocument.body.appendChild(document.createElement('i'))
    probe.style.cssText = 'forced-color-adjust: none; background: Highlight'
    const { backgroundColor } = getComputedStyle(probe)
    probe.remove()
    return backgroundColor
  })

async function showsChoice(chosen: Locator, other: Locator) {
  const colour = await highlight(chosen)
  // What a press opens may still be on its way.
  await expect.poll(async () => (await painted(chosen)).backgroundColor).toBe(colour)
  await expect.poll(async () => (await painted(other)).backgroundColor).not.toBe(colour)
}

/** The same of what is painted: a ring so many px from the edge of what answers to a hand. */
async function showsRing(child: Child, chosen: Locator, other: Locator, off: number) {
  const [colour] = (await highlight(chosen)).match(/\d+, *\d+, *\d+/) ?? ['none']
  const ring = async (thing: Locator) => {
    const { x, y, width, height } = (await thing.boundingBox())!
    const painted = await child.painted.colourAt({ x: x + width / 2, y: y + height + off })
    return farFrom(colour, painted)
  }
  await expect.poll(() => ring(chosen)).toBeLessThan(3)
  await expect.poll(() => ring(other)).toBeGreaterThan(30)
}

/** By how much the channels of two colours differ at most. */
function farFrom(colour: string, painted: string): number {
  const [a, b] = [colour, painted].map((one) => one.split(',').map(Number)) as [number[], number[]]
  return Math.max(...a.map((part, i) => Math.abs(part - b[i]!)))
}

test('forced colours show tabs, toggles, start places, knobs and neurons that are chosen', async ({
  child,
  page,
}) => {
  await child.opensLab('friendship')
  await showsChoice(child.button('lab.place', { number: 1 }), child.button('lab.place', { number: 2 }))
  const [de, en] = [
    page.getByRole('button', { name: 'Deutsch' }),
    page.getByRole('button', { name: 'English' }),
  ]
  await showsChoice(en, de)
  await child.presses('lab.closely')
  await showsChoice(child.button('lab.closely'), child.button('lab.larger'))

  await child.knob(leftEye, leftWheel).focus()
  await child.knob(rightEye, rightWheel).focus()
  await child.button('lab.menu').focus()
  await showsRing(child, child.knob(rightEye, rightWheel), child.knob(leftEye, leftWheel), -2)
  await showsRing(child, child.output(rightWheel), child.output(leftWheel), 2.5)

  await page.setViewportSize({ width: 390, height: 844 })
  const tab = (name: string) =>
    page
      .getByRole('navigation', { name: child.word('lab.panes') })
      .getByRole('button', { name: child.word(name) })
  await showsChoice(tab('lab.world'), tab('lab.program'))
})

test('forced colours show what counts and what is touched in sorting, on the same paper', async ({
  child,
  page,
}) => {
  const sorting = new SortingHands(child)
  await sorting.opens()
  await showsChoice(child.button('sorting.tab.things'), child.button('sorting.tab.points'))
  await showsChoice(
    page.getByRole('switch', { checked: true }).first(),
    page.getByRole('switch', { checked: false }).first(),
  )
  const [bottle, glass] = [sorting.thing('bottle', 1), sorting.thing('glass', 12)]
  await bottle.click()
  await showsChoice(bottle, glass)
  const paper = page.locator('.plane')
  await expect.poll(async () => (await painted(paper)).backgroundColor).toBe('rgb(255, 253, 248)')
})
