// Rooms: app
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const pane = (child: Child, name: 'program' | 'world' | 'network') =>
  child.page.getByRole('region', { name: child.word(`lab.${name}`), exact: true })

for (const language of languagesOf(import.meta.filename))
  test.describe(`with keys, in ${language}`, () => {
    test.use({ language })

    test('skip links and twelve Tabs lead from the top of a page to the first knob', async ({
      child,
      page,
    }) => {
      await child.opensLab('friendship')
      for (const size of [
        { width: 1366, height: 768 },
        { width: 1024, height: 768 },
      ]) {
        await page.setViewportSize(size)
        await page.evaluate(() => {
          document.body.tabIndex = -1
          document.body.focus()
          document.body.removeAttribute('tabindex')
        })
        let tabs = 0
        const tab = async () => {
          await child.types('Tab')
          tabs += 1
        }
        await tab()
        await expect(page.getByRole('link', { name: child.word('lab.toRobot') })).toBeFocused()
        await tab()
        const skip = page.getByRole('link', { name: child.word('lab.toNetwork') })
        await expect(skip).toBeFocused()
        await expect.poll(async () => (await skip.boundingBox())!.height).toBeGreaterThanOrEqual(44)
        await child.types('Enter')
        await expect(pane(child, 'network')).toBeFocused()
        while (tabs < 13 && !(await child.knobs.first().evaluate((one) => one === document.activeElement)))
          await tab()
        await expect(child.knobs.first()).toBeFocused()
        expect(tabs).toBeLessThanOrEqual(12)
      }
    })

    test('F6 goes round the parts of the lab, Shift and F6 back, also where one fills the window', async ({
      child,
      page,
    }) => {
      await child.opensLab('friendship')
      for (const name of ['program', 'world', 'network', 'program'] as const) {
        await child.types('F6')
        await expect(pane(child, name)).toBeFocused()
      }
      // From inside of a part too, and past Blockly's own keys.
      await child.types('Tab', 'Shift+F6')
      await expect(pane(child, 'network')).toBeFocused()
      await child.presses('lab.fill', { pane: child.word('lab.network') })
      await child.types('Shift+F6')
      await expect(pane(child, 'world')).toBeFocused()
      await expect(pane(child, 'network')).toBeHidden()
      await page.setViewportSize({ width: 390, height: 844 })
      await expect(page.getByRole('navigation', { name: child.word('lab.panes') })).toBeVisible()
      await child.types('F6')
      await expect(pane(child, 'network')).toBeFocused()
    })

    test('after a change of page the focus is where the page begins, and its name is said', async ({
      child,
      page,
    }) => {
      const said = page.locator('#svelte-announcer')
      await child.opensHome()
      await child.types('Tab')
      await expect(page.getByRole('link', { name: child.word('parts.skip') })).toBeFocused()
      await child.types('Enter')
      await expect(page.getByRole('main')).toBeFocused()

      await page.getByRole('link', { name: child.word('parts.myProjects') }).click()
      await expect(page.getByRole('heading', { level: 1 })).toBeFocused()
      await expect(said).toHaveText(`${child.word('projects.title')} · Botgarten`)
      await page.getByRole('link', { name: child.word('parts.home') }).click()
      await expect(page.getByRole('heading', { level: 1 })).toBeFocused()
      await page.getByRole('link', { name: child.card('friendship'), exact: true }).click()
      await expect(page.getByRole('main', { name: child.card('friendship') })).toBeFocused()
      await expect(said).toHaveText(`${child.card('friendship')} · Botgarten`)
    })
  })

test('who goes on from block to block at once never loses the place', async ({ child }) => {
  await child.opensLab('new-colours')
  await child.seesBlocks()
  const lost = await child.canvas.evaluate(async (canvas) => {
    const blocks = [...canvas.querySelectorAll<SVGElement>('.blocklyDraggable > .blocklyPath')]
    const frame = () => new Promise((done) => requestAnimationFrame(done))
    let lost = 0
    for (const [index, block] of blocks.entries()) {
      block.focus()
      const next = blocks[(index + 1) % blocks.length]!
      next.focus()
      // A number is its field and nothing else: its block takes no focus.
      const came = document.activeElement
      for (let passed = 0; passed < 3; passed += 1) await frame()
      if (document.activeElement !== came) lost += 1
    }
    return blocks.length > 5 ? lost : null
  })
  expect(lost).toBe(0)
})
