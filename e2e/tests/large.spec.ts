// Rooms: editor
import { bigFile } from '../big-file.ts'
import { Comer } from '../child-open-roberta.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const big = bigFile(10, 50)
const looped = bigFile(2, 100, true)

/** The ids of all blocks, stack by stack, in the order of the file. */
const order = (xml: string) =>
  xml
    .split('<config>')[0]!
    .split('<instance')
    .slice(1)
    .map((stack) => [...stack.matchAll(/<block [^>]*id="([^"]+)"/g)].map(([, id]) => id))

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a program of 2,010 blocks, in ${language}`, () => {
    test.use({ language })

    test('what is moved as soon as it is seen takes all its blocks along, and nothing is lost', async ({
      child,
      page,
    }) => {
      const comer = new Comer(child)
      await comer.opensAtHome('Big.xml', big)
      await comer.seesProgram('Big')
      const start = child.block('start')
      const box = (await start.boundingBox())!
      await page.mouse.move(box.x + 12, box.y + 12)
      await page.mouse.down()
      await page.mouse.move(box.x + 40, box.y + 40, { steps: 4 })
      await page.mouse.up()
      await expect(child.button('lab.undo')).toBeEnabled()
      const { text } = await comer.saves()
      expect(text).not.toContain('<instance x="40" y="40">')
      expect(order(text)).toEqual(order(big))
    })

    test('while it is still being filled it is saved whole, a block is deleted and comes back, and a reload loses nothing', async ({
      child,
      page,
    }) => {
      const comer = new Comer(child)
      const made = () => page.locator('.blocklyBlockCanvas .blocklyDraggable').count()
      await comer.opensAtHome('Big.xml', big)
      await comer.seesProgram('Big')
      await expect.poll(made).toBeLessThan(2010)
      await child.block('b0-0-').click({ position: { x: 12, y: 12 } })
      await page.keyboard.press('Delete')
      await expect(child.block('b0-0-')).toHaveCount(0)
      await child.seesSaved()
      await child.presses('lab.undo')
      await expect(child.block('b0-0-')).toHaveCount(1)
      // The block is back on the screen some frames before it is in the project.
      await expect.poll(async () => order((await comer.saves()).text)).toEqual(order(big))
      await child.seesSaved()

      // Twice, the first time in the middle of it: what is kept is the whole program.
      await page.reload()
      await child.block('start').waitFor()
      await expect.poll(made).toBeLessThan(2010)
      await page.reload()
      await comer.seesProgram('Big')
      expect(order((await comer.saves()).text)).toEqual(order(big))
    })
  })
}

test('the keyboard goes where nothing is drawn yet, deletes there and takes it back', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  await comer.opensAtHome('Loop.xml', looped)
  await comer.seesProgram('Loop')
  await child.block('start').click({ position: { x: 12, y: 12 } })
  const here = page.locator('.blocklyPath.blocklyActiveFocus')
  for (let presses = 0; presses < 60; presses += 1) await page.keyboard.press('ArrowDown')
  await expect(here).toBeInViewport()
  const id = await here.evaluate((path) => path.closest('[data-id]')!.getAttribute('data-id'))
  expect(id).toMatch(/^b0-[23]\d-/)
  const reached = page.locator(`[data-id="${id}"]`)
  await page.keyboard.press('Delete')
  await expect(reached).toHaveCount(0)
  await page.keyboard.press('Control+z')
  await expect(reached).toHaveCount(1)
  const { text } = await comer.saves()
  expect(order(text)).toEqual(order(looped))
})

test('what is scrolled to is drawn, and the loop reaches round all its blocks', async ({ child, page }) => {
  const comer = new Comer(child)
  await comer.opensAtHome('Loop.xml', looped)
  await comer.seesProgram('Loop')
  await expect(page.locator('[data-id="b0-99-c"]')).toHaveCount(1)
  const last = child.block('b0-99-c')
  await expect(last).not.toBeInViewport()
  await page.locator('.blocklySvg').first().hover()
  await page.mouse.wheel(0, 60_000)
  await expect(last).toBeInViewport()
  const loop = (await child.block('loop').boundingBox())!
  const inside = (await last.boundingBox())!
  expect(loop.y + loop.height).toBeGreaterThan(inside.y + inside.height)
  await page.mouse.wheel(0, -60_000)
  await expect(child.block('start')).toBeInViewport()
  await expect(last).not.toBeInViewport()
})
