// Rooms: app
// By address: links that lead nowhere.
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`addresses that lead nowhere, in ${language}`, () => {
    // The browser itself notes that the server has answered with 404.
    test.use({ language, complaints: [/status of 404/] })

    for (const [what, path, title, text] of [
      ['a card that is not there', '/lab/nosuchcard', 'lab.unknownCardTitle', 'lab.unknownCardText'],
      [
        'a card that is a word of every object',
        '/lab/constructor',
        'lab.unknownCardTitle',
        'lab.unknownCardText',
      ],
      ['a page that is not there', '/no/such/page', 'parts.lostTitle', 'parts.lostText'],
    ] as const)
      test(`${what}: the page says so and leads home`, async ({ child, page }) => {
        await page.goto(path)
        await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.word(title))
        await expect(child.words(text)).toBeVisible()
        await page.getByRole('link', { name: child.word('parts.toHome') }).click()
        await expect(page.getByRole('heading', { level: 1 })).toContainText(child.word('home.title'))
      })

    test('a project that is not there: its card begins again', async ({ child, page }) => {
      await page.goto('/lab/fear?p=fear-nosuchproject')
      await child.seesBlocks()
      await expect(child.knobs).toHaveCount(4)
      await child.pressesStart()
    })
  })
}
