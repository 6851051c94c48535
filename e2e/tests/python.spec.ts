// Rooms: python
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from '../house.ts'
import { freeProgram, projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

/** What `botgarten convert` makes of a project's file. */
function converted(project: string, language: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-'))
  const [from, to] = [join(folder, 'project.json'), join(folder, 'project.py')]
  writeFileSync(from, project)
  const cli = join(import.meta.dirname, '../../apps/cli/botgarten.ts')
  execFileSync(process.execPath, [cli, 'convert', from, to, '--lang', language])
  return readFileSync(to, 'utf8')
}

/** Something that Pybricks cannot do, and something that nobody has finished. */
const lacking = freeProgram('Talks', (make) => [
  make.block('robActions_sayText', { values: { OUT: make.block('text', { fields: { TEXT: 'Hi' } }) } }),
  make.block('robControls_wait_time'),
])

const steps = freeProgram('Steps', (make) => [make.wait(100), make.wait(200), make.wait(300)])

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the program as code, in ${language}`, () => {
    test.use({ language })

    test('it stands beside the blocks, for every robot, and block and line light up together', async ({
      child,
      page,
    }) => {
      await child.opensProjectAtHome('Steps', steps)
      await child.presses('lab.code')
      const line = (text: string) => page.getByRole('option').filter({ hasText: text })
      await expect(line('wait(200)')).toBeVisible()
      await child.block('b4').click({ position: { x: 28, y: 20 } })
      await expect(line('wait(200)')).toHaveAttribute('aria-selected', 'true')
      const list = page.getByRole('listbox')
      await list.focus()
      await page.keyboard.press('Home')
      await expect(list).toHaveAttribute('aria-activedescendant', /-0$/)
      await page.getByRole('button', { name: child.word('python.library.ev3dev2') }).click()
      await expect(line('sleep(0.2)')).toHaveAttribute('aria-selected', 'true')
      await page.getByRole('button', { name: child.word('python.library.spike') }).click()
      await expect(line('wait(200)')).toHaveAttribute('aria-selected', 'true')
    })

    test('what is saved is what is shown, and what the command line makes', async ({ child, page }) => {
      const project = projectFile('friendship', 'solution')
      await child.opensProjectAtHome('Friendship', project)
      await child.presses('lab.code')
      const rows = page.locator('[role=option]')
      await expect(rows.first()).toBeVisible()
      const shown = await rows.locator('> span:last-child').allTextContents()
      const saved = page.waitForEvent('download')
      await page.getByRole('button', { name: /\.py/ }).click()
      const file = await saved
      expect(file.suggestedFilename()).toMatch(/\.py$/)
      expect(readFileSync(await file.path(), 'utf8')).toBe(`${shown.join('\n')}\n`)
      expect(`${shown.join('\n')}\n`).toBe(converted(project, language))
    })

    test('what has a gap is an error or a comment, as the child likes', async ({ child, page }) => {
      await child.opensProjectAtHome('Talks', lacking)
      await child.presses('lab.code')
      const error = page.getByRole('option').filter({ hasText: 'raise NotImplementedError' })
      await expect(error).toBeVisible()
      await page.getByRole('switch', { name: child.word('python.gaps') }).click()
      await expect(error).toHaveCount(0)
    })

    test('what the brick lacks is shown at its block, for the robot that lacks it', async ({
      child,
      page,
    }) => {
      await child.opensProjectAtHome('Talks', lacking)
      await child.presses('lab.code')
      const badge = page.locator('.editor-badge:has(.robot)')
      await badge.click()
      await expect(page.getByText(child.word('python.atBlock.title'))).toBeVisible()
      await page.getByRole('button', { name: child.word('python.library.ev3dev2') }).click()
      await expect(badge).toHaveCount(0)
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
