// By address: the subject is the first document of a browser, which has not loaded anything else.
import type { Page } from '@playwright/test'
import { promised } from '../../packages/browsers/promised.ts'
import { languages, message } from '../words.ts'
import { expect, test } from './gate.ts'

// The page logs errors in such a browser.
test.use({ complaints: [/./] })

const box = (page: Page) => page.locator('#older')

async function seesMessage(page: Page) {
  await expect(box(page)).toBeVisible()
  for (const language of languages)
    await expect(box(page)).toContainText(message(language, 'older.text', promised))
}

test(
  'a browser without scripts shows a message in both languages on every page',
  { tag: '@/' },
  async ({ browser, house }) => {
    const context = await browser.newContext({ javaScriptEnabled: false, baseURL: house })
    const page = await context.newPage()
    for (const address of ['/', '/lab/friendship', '/no/such/page']) {
      await page.goto(address)
      await seesMessage(page)
      await expect(box(page).locator('button')).toBeHidden()
    }
    await context.close()
  },
)

test(
  'a browser that lacks an API of all promised ones shows the message, which can be closed',
  { tag: '@/' },
  async ({ page }) => {
    await page.addInitScript(() => Reflect.deleteProperty(Array.prototype, 'toSorted'))
    await page.goto('/')
    await seesMessage(page)
    await box(page).getByRole('button').click()
    await expect(box(page)).toBeHidden()
  },
)

test(
  'a page whose scripts cannot be loaded shows the message instead of nothing',
  { tag: '@/' },
  async ({ page }) => {
    await page.route(/\/immutable\/entry\//, (route) => route.abort())
    await page.goto('/')
    await seesMessage(page)
    await page.unroute(/\/immutable\/entry\//)
    await page.reload()
    await expect(page.getByRole('main')).toBeVisible()
    await expect(box(page)).toBeHidden()
  },
)
