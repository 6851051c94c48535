import { countingProject } from '../../projects.ts'
import { expect, opensProject, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

test('a run is looked at closely, step by step', { tag: '@debug' }, async ({ child, page }) => {
  const panel = page.locator('.debug')
  const last = child.canvas.locator('.robControls_wait_time').last()
  const here = child.button('debug.stopHere')
  const chooses = async () => {
    const id = (await last.getAttribute('data-id'))!
    await child.block(id).click({ position: { x: 28, y: 20 } })
  }
  await goesThrough(child, 'debug', {
    'a program': () => opensProject(child, 'Counts', countingProject('Counts')),
    closely: () => child.presses('lab.closely'),
    'a block is chosen': chooses,
    'a run is to stop there': () => here.click(),
    'it has stopped there': async () => {
      await child.presses('lab.start')
      await expect(child.words('debug.waits')).toBeVisible()
    },
    'it goes on to the end': async () => {
      await panel.getByRole('button', { name: child.word('lab.continue') }).click()
      await expect(child.button('lab.start').first()).toBeVisible()
    },
    'a step over a block': async () => {
      await child.presses('debug.over')
      await expect(page.locator('.editor-lit')).toHaveCount(1)
    },
    'it is closed': () => panel.getByRole('button', { name: child.word('parts.close') }).click(),
  })
})
