import { expect, opensCard, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

test('a goal is missed, step by step', { tag: '@missed' }, async ({ child, page }) => {
  await goesThrough(child, 'missed', {
    'the first card': () => opensCard(child, 'forward'),
    'its goal is missed': async () => {
      await child.pressesStart()
      await expect(child.button('lab.start').first()).toBeVisible()
      await expect(page.getByText(child.word('missed.ask'))).toBeAttached()
    },
    'it is known': () => page.locator('.missed').getByRole('button').click(),
  })
})
