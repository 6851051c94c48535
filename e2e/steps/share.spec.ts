import { ProjectList } from '../child-projects.ts'
import { freeProgram } from '../projects.ts'
import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** A text that does not become smaller by compressing. */
function noise(length: number): string {
  let seed = 1
  return Array.from({ length }, () => (seed = (seed * 48271) % 2147483647) % 10).join('')
}

/** A project with a text. `letters`: its length. */
function projectOf(name: string, letters: number) {
  const file = JSON.parse(freeProgram(name, (make) => [make.wait(1)])) as {
    programs: { main: { stacks: { blocks: object[] }[] } }
  }
  // A text may have 15,000 letters.
  for (const [at, part] of (noise(letters).match(/.{1,15000}/g) ?? []).entries())
    file.programs.main.stacks[0]!.blocks.push({ id: `n${at}`, type: 'text', data: part })
  return file
}

test('a project as a link, step by step', { tag: '@share' }, async ({ child, page }) => {
  const list = new ProjectList(child)
  const dialog = page.getByRole('dialog')
  const link = page.getByRole('textbox', { name: child.word('share.address') })
  const code = page.getByRole('img', { name: child.word('share.code') })
  const sizes = { Small: 0, Long: 4000, Large: 30_000 }
  const projects = Object.entries(sizes).map(([name, letters], at) => ({
    ...{ id: `free-${name.toLowerCase()}`, changed: 1000 + at, project: projectOf(name, letters) },
  }))
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  await list.opens()
  await list.opensFile('home.botgarten.json', JSON.stringify({ botgartenHome: 1, projects }))
  await expect(page.locator('article h2')).toHaveCount(3)
  await expect(dialog).toBeVisible()
  await child.types('Escape')
  await expect(dialog).toHaveCount(0)
  await goesThrough(
    child,
    'share',
    {
      'a link': async () => {
        await list.chooses('Small', 'share')
        await expect(code).toHaveAttribute('viewBox', /\d/)
        await expect(code.locator('path')).toHaveAttribute('d', /M/)
        await page.getByRole('heading', { name: child.word('share.title', { name: 'Small' }) }).click()
        await link.focus()
        await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toContain('/open#')
      },
      'it is copied': () => child.presses('share.copy'),
      'the dialog is closed': () => child.presses('parts.close'),
      'a link that no camera reads': () => list.chooses('Long', 'share'),
      'it cannot be copied': async () => {
        await page.evaluate(() => {
          Object.defineProperty(navigator, 'clipboard', { value: undefined })
          document.execCommand = () => false
        })
        await child.presses('share.copy')
      },
      'the dialog is left by a key': () => child.types('Escape'),
      'a project that is too large': () => list.chooses('Large', 'share'),
      'its file is saved': async () => {
        const save = dialog.getByRole('button', { name: child.word('projects.saveFile'), exact: true })
        await Promise.all([page.waitForEvent('download'), save.click()])
        await child.types('Escape')
      },
    },
    { hides: /(?<=\/open#)[\w.-]+/g },
  )
})
