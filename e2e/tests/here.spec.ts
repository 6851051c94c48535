// Rooms: here, server
// By address: the first start opens this page.
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`the page of the machine that serves, in ${language}`, () => {
    test.use({
      language,
      // The same server under a name that others may have for it.
      complaints: [/^A request to http:\/\/guest\.localhost:\d+\//],
    })

    test('asks if a class begins, and takes the link of the first teacher along', async ({ child, page }) => {
      await page.goto('/here#a-link-of-the-first-teacher')
      const way = (key: string) => page.getByRole('link', { name: child.word(key) })
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.word('here.title'))
      await expect(page.getByText(child.word('here.kept'))).toContainText('botgarten-data-')
      await child.tabsTo(way('here.class').first())
      await child.types('Enter')
      await expect(page).toHaveURL(/\/teacher\/start#a-link-of-the-first-teacher$/)
      await page.goBack()
      await way('here.alone').click()
      await expect(page).toHaveURL(/\/$/)
      await child.seesTitle()
    })

    test('tells a guest nothing of the machine', async ({ child, page, house }) => {
      await page.goto(`http://guest.localhost:${new URL(house).port}/here`)
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.word('here.elsewhere'))
      await expect(page.getByText(child.word('here.kept'))).toHaveCount(0)
      await expect(page.getByRole('link', { name: child.word('here.join') })).toHaveAttribute('href', '/join')
    })
  })
