// Rooms: debug
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

/** Drive, turn, wait: three blocks in a row. */
const steps = freeProgram('Steps', (make) => [make.wait(100), make.wait(200), make.wait(300)])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`looking closely, in ${language}`, () => {
    test.use({ language })

    test('a run stops where the child has said, goes on from there, and no more when it is taken away', async ({
      child,
      page,
    }) => {
      await child.opensProjectAtHome('Steps', steps)
      await child.presses('lab.closely')
      const here = child.button('debug.stopHere')
      await expect(here).toHaveAttribute('aria-disabled', 'true')
      await child.block('b4').click({ position: { x: 28, y: 20 } })
      await here.click()
      await expect(here).toHaveAttribute('aria-pressed', 'true')
      await expect(page.locator('.editor-stop')).toHaveCount(1)

      await child.presses('lab.start')
      await expect(page.getByText(child.word('debug.waits'))).toBeVisible()
      await expect(page.locator('.editor-lit')).toHaveAttribute('data-id', 'b4')
      await child.presses('lab.continue')
      await expect(child.button('lab.start').first()).toBeVisible()

      await child.block('b4').click({ position: { x: 28, y: 20 } })
      await here.click()
      await expect(page.locator('.editor-stop')).toHaveCount(0)
      await child.pressesStart()
      await expect(child.button('lab.start').first()).toBeVisible()
    })

    test('a run does not stop where nobody looks closely any more', async ({ child, page }) => {
      await child.opensProjectAtHome('Steps', steps)
      await child.presses('lab.closely')
      await child.block('b4').click({ position: { x: 28, y: 20 } })
      await child.presses('debug.stopHere')
      await expect(page.locator('.editor-stop')).toHaveCount(1)
      await child.presses('lab.closely')
      await expect(page.locator('.editor-stop')).toHaveCount(0)
      await child.pressesStart()
      await expect(child.button('lab.start').first()).toBeVisible()

      await child.presses('lab.closely')
      await expect(page.locator('.editor-stop')).toHaveCount(1)
      await child.presses('lab.start')
      await expect(page.getByText(child.word('debug.waits'))).toBeVisible()
      await child.presses('lab.continue')
      await expect(child.button('lab.start').first()).toBeVisible()
    })

    test('step by step, by the keyboard', async ({ child, page }) => {
      await child.opensProjectAtHome('Steps', steps)
      await child.button('lab.closely').focus()
      await page.keyboard.press('Enter')
      const next = child.button('lab.stepBlock').first()
      await expect(next).toBeVisible()
      await next.focus()
      for (const key of ['Enter', 'Enter']) await page.keyboard.press(key)
      await expect(page.locator('.editor-lit')).toHaveCount(1)
      await child.button('debug.over').focus()
      await page.keyboard.press('Enter')
      await expect(page.locator('.editor-lit')).toHaveCount(1)
    })
  })
}
