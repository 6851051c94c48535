// Rooms: python
import { readFileSync } from 'node:fs'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const steps = freeProgram('Steps', (make) => [make.wait(100), make.wait(200), make.wait(300)])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the program as code, in ${language}`, () => {
    test.use({ language })

    test('it stands beside the blocks, for both robots, and block and line light up together', async ({
      child,
      page,
    }) => {
      await child.opensLab('free')
      await child.opensProject('Steps', steps)
      await child.presses('lab.code')
      const line = (text: string) => page.getByRole('option').filter({ hasText: text })
      await expect(line('wait(200)')).toBeVisible()
      await child.block('b4').click({ position: { x: 28, y: 20 } })
      await expect(line('wait(200)')).toHaveAttribute('aria-selected', 'true')
      await page.getByRole('button', { name: child.word('python.library.ev3dev2') }).click()
      await expect(line('sleep(0.2)')).toHaveAttribute('aria-selected', 'true')
    })

    test('what is saved is what is shown', async ({ child, page }) => {
      await child.opensLab('friendship')
      await child.presses('lab.code')
      const rows = page.locator('[role=option]')
      await expect(rows.first()).toBeVisible()
      const shown = await rows.locator('> span:last-child').allTextContents()
      const saved = page.waitForEvent('download')
      await page.getByRole('button', { name: /\.py/ }).click()
      const file = await saved
      expect(file.suggestedFilename()).toMatch(/\.py$/)
      expect(readFileSync(await file.path(), 'utf8')).toBe(`${shown.join('\n')}\n`)
    })

    test('on a phone it has a tab of its own', async ({ child, page }) => {
      await page.setViewportSize({ width: 390, height: 844 })
      await child.opensLab('friendship')
      await page
        .getByRole('navigation')
        .getByRole('button', { name: child.word('lab.code') })
        .click()
      await expect(page.getByRole('option').filter({ hasText: 'def think(inputs):' })).toBeVisible()
      await page
        .getByRole('navigation')
        .getByRole('button', { name: child.word('lab.networkTab') })
        .click()
      await expect(page.locator('[role=option]')).toHaveCount(0)
    })
  })
}
