// By address: the subject is the first document of a browser, which has not loaded anything else.
import { expect, test } from './gate.ts'
import { languages, message } from '../words.ts'

// The page logs errors in such a browser.
test.use({ complaints: [/./] })

test(
  'a browser without scripts shows a sentence in both languages on every page',
  { tag: '@/' },
  async ({ browser, house }) => {
    const context = await browser.newContext({ javaScriptEnabled: false, baseURL: house })
    const page = await context.newPage()
    for (const address of ['/', '/lab/friendship', '/no/such/page']) {
      await page.goto(address)
      for (const language of languages) {
        // Searches by text skip noscript elements.
        const text = page.locator(`noscript p[lang=${language}]`)
        await expect(text).toBeVisible()
        await expect.poll(() => text.textContent()).toBe(message(language, 'older.noScript'))
      }
    }
    await context.close()
  },
)

test(
  'a browser that lacks what all promised ones have shows so, and the sentence can be closed',
  { tag: '@/' },
  async ({ page }) => {
    await page.addInitScript(() => Reflect.deleteProperty(Array.prototype, 'toSorted'))
    await page.goto('/')
    const alert = page.locator('#browser-old')
    for (const language of languages) await expect(alert).toContainText(message(language, 'older.title'))
    await expect(alert).toContainText('Safari 16.4')
    await alert.getByRole('button').click()
    await expect(alert).toBeHidden()
  },
)

test(
  'a page whose scripts cannot be loaded shows a sentence instead of nothing',
  { tag: '@/' },
  async ({ page }) => {
    await page.route(/\/immutable\/entry\//, (route) => route.abort())
    await page.goto('/')
    const alert = page.locator('#page-failed')
    for (const language of languages) await expect(alert).toContainText(message(language, 'older.broken'))
    await page.unroute(/\/immutable\/entry\//)
    await page.reload()
    await expect(page.getByRole('main')).toBeVisible()
    await expect(alert).toBeHidden()
  },
)
