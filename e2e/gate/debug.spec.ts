import { countingProject } from '../projects.ts'
import { expect, opensProject, test } from './gate.ts'

test.use({ language: 'en' })

test(
  'a run stops where the child has said, shows what a variable holds, and goes on block by block',
  {
    tag: '@debug',
  },
  async ({ child, page }) => {
    await opensProject(child, 'Counts', countingProject('Counts'))
    const waits = child.canvas.locator('.robControls_wait_time')
    const last = (await waits.last().getAttribute('data-id'))!
    await child.presses('lab.closely')
    await child.block(last).click({ position: { x: 28, y: 20 } })
    const here = child.button('debug.stopHere')
    await here.click()
    await expect(here).toHaveAttribute('aria-pressed', 'true')
    await child.presses('lab.start')
    await expect(child.words('debug.waits')).toBeVisible()
    await expect(page.locator('.editor-lit')).toHaveAttribute('data-id', last)
    const value = page.locator('.debug').getByRole('row', { name: /^x/ }).getByRole('cell')
    await expect(value).toHaveText('12')
    await child.presses('lab.continue')
    await expect(child.button('lab.start').first()).toBeVisible()

    await child.block(last).click({ position: { x: 28, y: 20 } })
    await here.click()
    await expect(page.locator('.editor-stop')).toHaveCount(0)
    const step = child.button('lab.stepBlock').first()
    await step.click()
    await step.click()
    await expect(page.locator('.editor-lit')).toHaveCount(1)
    await expect(value).toHaveText('7')
  },
)
