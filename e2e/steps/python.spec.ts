import { freeProgram } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** A block that Pybricks does not know, and a block with a gap. */
const lacking = freeProgram('Talks', (make) => [
  make.block('robActions_sayText', { values: { OUT: make.block('text', { fields: { TEXT: 'Hi' } }) } }),
  make.block('robControls_wait_time'),
  make.wait(200),
  make.wait(300),
])

test('a program as text, step by step', { tag: '@python' }, async ({ child, page, context }) => {
  const library = (name: string) => page.getByRole('button', { name: child.word(`python.library.${name}`) })
  const list = page.getByRole('listbox')
  const line = (text: string) => list.getByRole('option').filter({ hasText: text })
  await goesThrough(child, 'python', {
    'the text beside the blocks': async () => {
      await opensProject(child, 'Talks', lacking)
      await child.presses('lab.code')
      await expect(line('wait(200)')).toBeVisible()
    },
    'for another robot': () => library('ev3dev2').click(),
    'for SPIKE': () => library('spike').click(),
    'gaps are comments': () => page.getByRole('switch', { name: child.word('python.gaps') }).click(),
    'lines are chosen by keys and by a press': async () => {
      const first = (await list.getByRole('option').first().getAttribute('id'))!
      await list.press('Home')
      await expect(list).toHaveAttribute('aria-activedescendant', first)
      await list.press('End')
      await list.press('Enter')
      await expect(line('wait(300)')).toHaveAttribute('aria-selected', 'true')
      await line('wait(200)').click()
      await expect(line('wait(200)')).toHaveAttribute('aria-selected', 'true')
    },
    'copied, saved and printed, for Pybricks': async () => {
      await context.grantPermissions(['clipboard-write'])
      await page.evaluate(() => (window.print = () => (document.title = 'printed')))
      await child.presses('python.copy')
      await expect(child.button('python.copied')).toBeVisible()
      const download = page.waitForEvent('download')
      await page.getByRole('button', { name: /\.py/ }).click()
      expect((await download).suggestedFilename()).toMatch(/^\w+\.py$/)
      await child.presses('python.print')
      await expect(page).toHaveTitle('printed')
      await page.evaluate(() => window.dispatchEvent(new Event('afterprint')))
      await library('pybricks').click()
      await expect(child.button('python.copy')).toBeVisible()
    },
    'a program that learns': async () => {
      await opensCard(child, 'railway')
      await child.presses('lab.unfold')
      await child.presses('lab.code')
      await expect(list.getByRole('option').first()).toBeVisible()
    },
    'it learns on the robot': () => page.getByRole('switch', { name: child.word('python.learns') }).click(),
  })
})
