import { BlockHands } from '../child-blocks.ts'
import { AskingHands } from '../child-explained.ts'
import { freeProgram } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** Waits of 0.1 s and a minute: `b2`, `b4`. */
const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(60_000)])

test('blocks are looked for and explained, step by step', { tag: '@editor' }, async ({ child, page }) => {
  const hands = new BlockHands(child)
  const asking = new AskingHands(child)
  const button = child.button('editor.search')
  const search = page.getByRole('search', { name: child.word('editor.search') })
  const blocks = child.canvas.locator('.blocklyDraggable')
  /** Something closes the search that is open; then it is opened again. */
  const closesBy = async (act: () => Promise<unknown>) => {
    await act()
    await expect(search).toHaveCount(0)
    await button.click()
    await expect(hands.field).toBeFocused()
  }
  const put = async (act: () => Promise<unknown>) => {
    const before = await blocks.count()
    await act()
    await expect.poll(() => blocks.count()).toBeGreaterThan(before)
  }
  await goesThrough(child, 'editor', {
    'the blocks': () => opensProject(child, 'Waits', waits),
    'the search': () => child.presses('editor.search'),
    'a word that is on no block here': () => hands.field.fill('random number'),
    'it is on one of all blocks': async () => {
      await child.presses('shelf.inAll')
      await expect(hands.field).toBeFocused()
    },
    'a word that is on several blocks': () => hands.field.fill('if'),
    'the next one': async () => {
      const before = await hands.field.getAttribute('aria-activedescendant')
      await hands.field.press('ArrowDown')
      await expect(hands.field).not.toHaveAttribute('aria-activedescendant', before!)
    },
    'it is put into the program': async () => {
      await put(() => hands.field.press('Enter'))
      await expect(search).toHaveCount(0)
      await child.presses('lab.undo')
    },
    'the search is closed and opened in every way': async () => {
      await button.click()
      await closesBy(() => child.types('Escape'))
      await closesBy(() => button.click())
      await closesBy(() => page.mouse.click(700, 600))
      await closesBy(() => hands.all.focus())
      await expect(button).toHaveAttribute('aria-expanded', 'true')
    },
    'one is put in by a press': async () => {
      await hands.field.fill('if')
      await put(() => hands.hits.first().click())
      await child.presses('lab.undo')
    },
    'one is pulled onto the paper': async () => {
      await hands.searches('wait')
      const before = await blocks.count()
      const paper = (await page.locator('.blocklySvg').first().boundingBox())!
      await hands.pulls(hands.hits.first(), { x: paper.x + 420, y: paper.y + 420 })
      await expect.poll(() => blocks.count()).toBeGreaterThan(before)
      await child.presses('lab.undo')
      await hands.all.click()
    },
    'what a block does': () => asking.asksByMenu(child.block('b2')),
    'its example is put in': async () => {
      await put(() => asking.takesIt())
      await child.presses('lab.undo')
    },
    'asked again': () => asking.asksByMenu(child.block('b2')),
    closed: () => asking.dialog.getByRole('button', { name: child.word('parts.close'), exact: true }).click(),
    'asked once more': () => asking.asksByMenu(child.block('b2')),
    'closed by keys': () => child.types('Escape'),
    'a block of a network lights up with its node': async () => {
      await opensCard(child, 'friendship')
      await child.block('wheelLeft').hover({ position: { x: 8, y: 14 } })
      await expect.poll(() => child.painted.lit()).toContain('neuron wheelLeft')
      await page.mouse.move(5, 5)
      await expect.poll(() => child.painted.lit()).toEqual([])
    },
  })
})
