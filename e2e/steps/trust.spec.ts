import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/status of 404/] })

test('trusting a server, step by step', { tag: '@trust' }, async ({ child, page }) => {
  const code = page.getByRole('img', { name: child.word('trust.code') })
  const opens = async () => {
    // By address: a class is given the address of this page.
    await page.goto('/trust')
    await child.seesTitle()
  }
  await goesThrough(child, 'trust', {
    'a server without https': opens,
    'a server with https': async () => {
      await page.route('**/https.json', (route) => route.fulfill({ json: { port: 4443 } }))
      await opens()
      await expect(code).toHaveAttribute('viewBox', /\d/)
      await expect(code.locator('path')).toHaveAttribute('d', /M/)
      await page.evaluate(() => (window.print = () => (document.title = 'printed')))
      await child.presses('trust.print')
      await expect(page).toHaveTitle('printed')
    },
  })
})
