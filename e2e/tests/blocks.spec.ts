// Rooms: editor
import type { Locator, Page } from '@playwright/test'
import { BlockHands } from '../child-blocks.ts'
import { Comer } from '../child-open-roberta.ts'
import { ProjectList } from '../child-projects.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

/** Waits of 0.1 s, a minute and half a minute: `b2`, `b4`, `b6`. */
const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(60_000), make.wait(30_000)])
const wait = 'robControls_wait_time'

const words = {
  en: { if: 'if', more: 'random number', unknown: 'xyzzy' },
  de: { if: 'wenn', more: 'Zufallszahl', unknown: 'xyzzy' },
}

const boxOf = async (thing: Locator) => (await thing.boundingBox())!

/** The switch, the rows of the shelf and the search do not lie on one another, and are as large as a finger. */
async function expectRoom(page: Page, hands: BlockHands, search: Locator) {
  const [above, below] = [await boxOf(search), await boxOf(hands.all)]
  const rows = await page.getByRole('treeitem').all()
  await rows[0]!.scrollIntoViewIfNeeded()
  const first = await boxOf(rows[0]!)
  expect(first.y).toBeGreaterThanOrEqual(above.y + above.height)
  for (const box of [above, below, first]) expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44)
  await rows.at(-1)!.scrollIntoViewIfNeeded()
  const last = await boxOf(rows.at(-1)!)
  expect(last.y + last.height).toBeLessThanOrEqual(below.y)
  expect(below.y + below.height).toBeLessThanOrEqual(page.viewportSize()!.height)
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the whole block language, in ${language}`, () => {
    test.use({ language })

    test('a switch shows every block; the project remembers it, other projects do not mind', async ({
      child,
      page,
    }) => {
      const hands = new BlockHands(child)
      await child.opensLab('free')
      await expect(hands.row('lists')).toHaveCount(0)
      await expectRoom(page, hands, child.button('editor.search'))
      await child.tabsTo(hands.all)
      await page.keyboard.press('Space')
      await expect(hands.row('lists')).toBeVisible()
      for (const width of [1024, 1366]) {
        await page.setViewportSize({ width, height: 768 })
        await expectRoom(page, hands, child.button('editor.search'))
      }
      await child.seesSaved()
      await child.reloads()
      await expect(hands.row('lists')).toBeVisible()
      await child.opensLab('friendship')
      await expect(hands.all).not.toBeChecked()
      await expect(hands.row('lists')).toHaveCount(0)
      const list = new ProjectList(child)
      await list.opens()
      await list.opensProject(child.word('home.free'))
      await hands.all.click()
      await expect(hands.row('lists')).toHaveCount(0)
    })

    test('a block is found by its words and put in by the keyboard alone', async ({ child, page }) => {
      const hands = new BlockHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.goesTo('b2')
      const before = await child.canvas.locator('.blocklyDraggable').count()
      await child.tabsAndPresses('editor.search')
      await expect(hands.field).toBeFocused()
      await page.keyboard.type(words[language].if)
      await expect(hands.hits.first()).toContainText(words[language].if)
      const said = await hands.hits.allTextContents()
      const at = said.findIndex((text) => text.startsWith(`${words[language].if} …`))
      await page.keyboard.press('ArrowUp')
      await expect(hands.hits.last()).toHaveAttribute('aria-selected', 'true')
      for (let presses = 0; presses <= at; presses += 1) await page.keyboard.press('ArrowDown')
      await expect(hands.hits.nth(at)).toHaveAttribute('aria-selected', 'true')
      await page.keyboard.press('Enter')
      await expect(hands.field).toHaveCount(0)
      await expect(child.canvas.locator('.blocklyDraggable')).toHaveCount(before + 1)
      const file = JSON.parse(await child.savesFile()) as {
        programs: { main: { stacks: { blocks: { type: string }[] }[] } }
      }
      const types = file.programs.main.stacks[0]!.blocks.map(({ type }) => type)
      expect(types.slice(1, 3)).toEqual([wait, 'robControls_if'])
      await page.keyboard.press('Escape')
      await child.presses('lab.undo')
      await expect(child.canvas.locator('.blocklyDraggable')).toHaveCount(before)
    })

    test('a number that is being typed is saved when the workspace is dragged next', async ({
      child,
      page,
    }) => {
      await child.opensProjectAtHome('Waits', waits)
      await child.press(child.block('b2').locator('.blocklyNumberField').first())
      await page.keyboard.press('ControlOrMeta+a')
      await child.types(...'700')
      // The pressed background closes the field, and the drag takes much longer than that.
      const pane = await boxOf(page.locator('.blocklyMainBackground').first())
      const [x, y] = [pane.x + pane.width * 0.6, pane.y + pane.height * 0.6]
      const hit = ([x, y]: number[]) => document.elementFromPoint(x!, y!)?.getAttribute('class')
      await expect.poll(() => page.evaluate(hit, [x, y])).toBe('blocklyMainBackground')
      await page.mouse.move(x, y)
      await page.mouse.down()
      for (const step of [10, 20, 30]) {
        await page.mouse.move(x + step, y + step)
        await child.watches(10)
      }
      await page.mouse.up()
      const file = await child.savesFile()
      expect(file).toContain('"700"')
    })

    test('a block that is found is pulled to where it belongs, in one step', async ({ child, page }) => {
      const hands = new BlockHands(child)
      await child.opensProjectAtHome('Waits', waits)
      const blocks = child.canvas.locator('.blocklyDraggable')
      const before = await blocks.count()
      const first = child.block('b1')
      const stands = await first.boundingBox()
      const pulls = async (to: { x: number; y: number }) => {
        await hands.searches(words[language].if)
        const hit = (await hands.hits.first().boundingBox())!
        await page.mouse.move(hit.x + 60, hit.y + 20)
        await page.mouse.down()
        await page.mouse.move(hit.x + 80, hit.y + 40, { steps: 3 })
        await expect(hands.field).toHaveCount(0)
        await page.mouse.move(to.x, to.y, { steps: 6 })
        await page.mouse.up()
        await expect(page.locator('.blocklyDragging')).toHaveCount(0)
      }
      await pulls({ x: stands!.x + 150, y: stands!.y + 320 })
      await expect.poll(() => blocks.count()).toBeGreaterThan(before)
      await expect.poll(() => first.boundingBox()).toEqual(stands)
      await child.presses('lab.undo')
      await expect(blocks).toHaveCount(before)
      const shelf = (await hands.row('control').boundingBox())!
      await pulls({ x: shelf.x + 30, y: shelf.y + 20 })
      await expect(blocks).toHaveCount(before)
    })

    test('what is not found is said, and all blocks can be looked through', async ({ child, page }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      const hands = new BlockHands(child)
      await child.opensLab('free')
      await hands.searches(words[language].unknown)
      const nothing = child.words('shelf.nothing', { query: words[language].unknown })
      await expect(nothing).toBeVisible()
      await hands.field.fill(words[language].more)
      await child.presses('shelf.inAll')
      await expect(hands.all).toBeChecked()
      await expect(hands.hits.first()).toContainText(words[language].more, { ignoreCase: true })
      await page.keyboard.press('Escape')
      await expect(hands.field).toHaveCount(0)
      await expect(child.button('editor.search')).toBeFocused()
      await hands.searches(words[language].more)
      await hands.hits.first().click()
      await expect(child.canvas.getByText(words[language].more).first()).toBeVisible()
    })

    test('a note, folding, switching off and doubling by the mouse are kept, in our file and in Open Roberta’s', async ({
      child,
      page,
    }) => {
      const hands = new BlockHands(child)
      const comer = new Comer(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.chooses('b2', 'ADD_COMMENT')
      await hands.writes('Ha < & >')
      const note = page.locator('.blocklyTextInputBubble')
      await expect(note).toBeVisible()
      await page.mouse.click(330, 660)
      await expect(note).toHaveCount(0)
      await hands.chooses('b4', 'DISABLE_BLOCK')
      await hands.chooses('b6', 'COLLAPSE_BLOCK')
      await hands.chooses('b2', 'DUPLICATE_BLOCK')
      const kept = await hands.inFile(wait)
      expect(
        kept.map(({ id, comment, disabled, collapsed }) => [
          id.length < 5 && id,
          comment,
          disabled,
          collapsed,
        ]),
      ).toEqual([
        ['b2', 'Ha < & >', undefined, undefined],
        ['b4', undefined, true, undefined],
        ['b6', undefined, undefined, true],
        [false, 'Ha < & >', undefined, undefined],
      ])
      await page.keyboard.press('Escape')
      const { text } = await comer.saves()
      expect(text).toMatch(/<block [^>]*id="b4"[^>]*disabled="true"|<block [^>]*disabled="true"[^>]*id="b4"/)
      expect(text).toMatch(
        /<block [^>]*id="b6"[^>]*collapsed="true"|<block [^>]*collapsed="true"[^>]*id="b6"/,
      )
      await comer.opens('again.xml', text)
      await comer.seesProgram('again')
      const again = await hands.inFile(wait)
      expect(again.map(({ comment, disabled, collapsed }) => [comment, disabled, collapsed])).toEqual(
        kept.map(({ comment, disabled, collapsed }) => [comment, disabled, collapsed]),
      )
    })

    test('the same by the keyboard; what is switched off is skipped', async ({ child, page }) => {
      const hands = new BlockHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.goesTo('b4')
      await hands.choosesByKeys('DISABLE_BLOCK')
      await hands.choosesByKeys('COLLAPSE_BLOCK')
      const lit = page.locator('.editor-lit')
      await child.pressesStart()
      await expect(lit).toHaveAttribute('data-id', 'b6')
      await child.pressesStop()
      await hands.goesTo('b4')
      await hands.choosesByKeys('EXPAND_BLOCK')
      await hands.choosesByKeys('ENABLE_BLOCK')
      await hands.choosesByKeys('ADD_COMMENT')
      await hands.writes('lang')
      await page.keyboard.press('Escape')
      await page.keyboard.press('Escape')
      await expect(page.locator('.blocklyTextInputBubble')).toHaveCount(0)
      await hands.goesTo('b4')
      await page.keyboard.press('d')
      const kept = await hands.inFile(wait)
      expect(kept.map(({ comment, disabled, collapsed }) => [comment, disabled, collapsed])).toEqual([
        [undefined, undefined, undefined],
        ['lang', undefined, undefined],
        [undefined, undefined, undefined],
        ['lang', undefined, undefined],
      ])
      await page.keyboard.press('Escape')
      await hands.chooses('b4', 'REMOVE_COMMENT')
      await child.pressesStart()
      await expect(lit).toHaveAttribute('data-id', 'b4')
      await child.pressesStop()
    })

    test('copies go from project to project, by keys and by menu', async ({ child, page }) => {
      const hands = new BlockHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.goesTo('b4')
      await page.keyboard.press('Control+c')
      await child.opensLab('friendship')
      const before = await hands.inFile(wait)
      expect(before).toEqual([])
      await page.keyboard.press('Escape')
      await hands.goesTo('start')
      await page.keyboard.press('Control+v')
      await expect.poll(async () => (await child.canvas.getByText('60000').count()) > 0).toBe(true)
      await page
        .locator('.blocklySvg')
        .first()
        .click({ button: 'right', position: { x: 340, y: 480 } })
      await hands.item('PASTE_SHORTCUT').click()
      await expect(child.canvas.getByText('60000')).toHaveCount(2)
      await child.presses('lab.undo')
      await expect(child.canvas.getByText('60000')).toHaveCount(1)
    })
  })
}
