// Rooms: app, world, editor, q-learning
import type { Locator } from '@playwright/test'
import { Learner } from '../child-learning.ts'
import { RobotHands } from '../child-robot.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'

// German words are the longest.
test.use({ language: 'de' })

/** How many px² of each other two parts of the page cover. */
async function shared(one: Locator, other: Locator): Promise<number> {
  const [a, b] = [await one.boundingBox(), await other.boundingBox()]
  if (!a || !b) throw new Error('Not on the page.')
  const along = (from: number, length: number, other: number, otherLength: number) =>
    Math.max(0, Math.min(from + length, other + otherLength) - Math.max(from, other))
  return along(a.x, a.width, b.x, b.width) * along(a.y, a.height, b.y, b.height)
}

/** By how many px the content of a part is larger than the part. */
const cut = (part: Locator) =>
  part.evaluate((element) =>
    Math.max(element.scrollWidth - element.clientWidth, element.scrollHeight - element.clientHeight),
  )

test('at 200 % zoom and on a phone the buttons that run the program are in one row, and no word is cut', async ({
  child,
  page,
}) => {
  await child.opensLab('chameleon')
  for (const size of [
    { width: 683, height: 384 },
    { width: 390, height: 844 },
    { width: 360, height: 740 },
  ]) {
    await page.setViewportSize(size)
    await expect(page.locator('.run')).toBeVisible()
    const rows = () =>
      page
        .locator('.run button')
        .evaluateAll(
          (all) => new Set(all.map((one) => Math.round(one.getBoundingClientRect().top / 20))).size,
        )
    for (const key of ['lab.start', 'lab.stop']) {
      await expect.poll(() => cut(child.button(key))).toBe(0)
      await expect.poll(rows).toBe(1)
      await child.presses(key)
    }
  }
})

test('the bin stays where it is when a block is chosen in a narrow program', async ({ child, page }) => {
  await child.opensLab('friendship')
  const border = page.getByRole('separator', { name: child.word('lab.borderProgram') })
  await border.focus()
  await child.types('Home')
  const place = () => child.button('lab.bin').boundingBox()
  await expect(child.button('editor.what')).toBeDisabled()
  const before = await place()
  await child.canvas
    .locator('.blocklyDraggable')
    .first()
    .click({ position: { x: 20, y: 25 } })
  await expect(child.button('editor.what')).toBeEnabled()
  expect(await place()).toEqual(before)
})

test('the button of the time machine leaves free what Bo senses', async ({ child }) => {
  await child.opensLab('friendship')
  const robot = new RobotHands(child)
  await robot.opens('senses')
  await child.pressesStart()
  const clock = child.button('time.open')
  await expect(clock).toBeEnabled()
  expect(await shared(clock, robot.drawer('senses'))).toBe(0)
})

test('a note leaves free what Bo has collected, and Bo that is stuck has a single one', async ({
  child,
  page,
}) => {
  await child.opensLab('new-colours')
  const collected = page.getByRole('region', { name: child.word('sorting.collected.title'), exact: true })
  const noteOf = (key: string) => page.getByRole('status').filter({ hasText: child.word(key) })
  const { x, y } = await child.painted.place('bo')
  await child.drags({ x, y }, { x: x + 60, y: y + 30 })
  await child.pressesStart()
  const elsewhere = noteOf('session.elsewhere')
  await expect(elsewhere).toBeVisible()
  expect(await shared(elsewhere, collected)).toBe(0)
  await child.pressesStop()

  await child.presses('lab.place', { number: 1 })
  await child.pressesStart()
  await new TimeHands(child).chooses('16')
  await expect(noteOf('world.bumped')).toBeVisible()
  await child.seesStanding()
  await expect(noteOf('world.lost')).toHaveCount(0)
  await child.press(noteOf('world.bumped').getByRole('button'))
  await expect(noteOf('world.lost')).toBeVisible()
  expect(await shared(noteOf('world.lost'), collected)).toBe(0)
})

test('the numbers of a move, and the sentence below them, are whole in any window', async ({
  child,
  page,
}) => {
  const learner = new Learner(child)
  await learner.opens('mars')
  await learner.hurries()
  await learner.learns()
  await learner.seesEnd()
  for (const size of [
    { width: 1366, height: 768 },
    { width: 1024, height: 768 },
    { width: 390, height: 844 },
    { width: 360, height: 740 },
  ]) {
    await page.setViewportSize(size)
    await expect(page.locator('.statistics')).toBeVisible()
    const wide = () =>
      page
        .locator('.statistics > div')
        .evaluateAll((all) =>
          all.filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent),
        )
    await expect.poll(wide).toEqual([])
    await expect.poll(() => cut(page.locator('.line .scroll'))).toBe(0)
  }
})
