// Rooms: materials
import { content } from '@botgarten/content/files'
import type { Item } from '@botgarten/content/items'
import type { Page } from '@playwright/test'
import { expect, test } from '../house.ts'
import { smallWords } from '../paper-words.ts'
import { readPdf } from '../pdf.ts'

/** What children read is set in this, in pt; what only the youngest read in the larger one. */
const least = { pupils: 11, youngest: 12 }

const leastOf = ({ audience, grades }: Item) =>
  audience === 'teachers' ? 0 : grades[1] <= 4 ? least.youngest : least.pupils

/** Plans have two pages and a test of their own; tables of what others wrote are as long as its language makes them. */
const apart = ['slides', 'plan', 'links']
const printed = content.items.filter(({ kind }) => !apart.includes(kind))

/** All of it as one pack, so that one page is opened. */
async function opensAll(page: Page) {
  const lines = printed.map(({ id }) => ({ of: `item:${id}`, for: 'teacher' }))
  const mySet = { name: '', children: 24, lines, paper: 'a4', grey: false }
  await page.addInitScript((set) => localStorage.setItem('botgarten.my-set', set), JSON.stringify(mySet))
  await page.goto('/materials/pack/my-set?paper=a4&address=https://botgarten.example.org')
  await page.locator('html[data-print=ready]').waitFor({ state: 'attached' })
}

/** Where each item begins in the file, as its cover says. */
const beginnings = (page: Page) =>
  page
    .locator('.pack-cover tbody tr > :nth-child(3)')
    .evaluateAll((all) => all.map((one) => parseInt(one.textContent)))

// In both languages: longer words make a page smaller, or a page more.
for (const language of ['de', 'en'] as const)
  test.describe(`on paper, in ${language}`, () => {
    test.use({ language })

    test('everything that children read is large enough, and the cover says how many pages there are', async ({
      page,
    }) => {
      // Some two hundred pages.
      test.slow()
      await opensAll(page)
      const sizes = await page.evaluate(smallWords, printed.map(leastOf))
      expect(sizes).toHaveLength(printed.length)
      expect(sizes.flatMap((small, at) => small.map((one) => `${printed[at]!.id}: ${one}`))).toEqual([])

      const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, tagged: true }))
      const begins = pages.flatMap(({ headings }, at) => (headings.includes(1) && at > 0 ? [at + 1] : []))
      // A cover of so many lines has pages of its own.
      const named = (numbers: readonly number[]) =>
        printed.map(({ id }, at) => `${id}: page ${numbers[at]! - numbers[0]!}`)
      expect(named(begins)).toEqual(named(await beginnings(page)))
    })
  })
