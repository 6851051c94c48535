// Rooms: materials
// By address: a window that is printed is opened by its address.
import { content } from '@botgarten/content/files'
import type { Item } from '@botgarten/content/items'
import type { Page } from '@playwright/test'
import { expect, test } from '../house.ts'
import { smallInPlans, smallWords } from '../paper-words.ts'
import { readOutside } from '../pdf.ts'
import { languagesOf } from '../words.ts'

/** What children read is set in this, in pt; what only the youngest read in the larger one. */
const least = { pupils: 11, youngest: 12 }

const leastOf = ({ audience, grades }: Item) =>
  audience === 'teachers' ? 0 : grades[1] <= 4 ? least.youngest : least.pupils

/** Tables of what others wrote are as long as its language makes them. */
const apart = ['slides', 'links']
const printed = content.items.filter(({ kind }) => !apart.includes(kind))

/** Every plan, with the pages that it has to have. */
const planned = printed
  .filter(({ plan }) => plan)
  .map(({ id, kind }) => ({ id, kind, sizes: ['210 × 297', '210 × 297'] }))
/** A teacher's plan, in pt. */
const leastOfPlans = 9.5

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

// One language in each sample: longer words make a page smaller, or a page more.
for (const language of languagesOf(import.meta.filename))
  test.describe(`on paper, in ${language}`, () => {
    test.use({ language })

    test('everything that children read is large enough, a plan has two pages that a teacher can read, and the cover says how many pages there are', async ({
      page,
    }) => {
      // Some two hundred and fifty pages.
      test.slow()
      await opensAll(page)
      const small = await page.evaluate(smallWords, printed.map(leastOf))
      expect(small).toHaveLength(printed.length)
      expect(small.flatMap((words, at) => words.map((one) => `${printed[at]!.id}: ${one}`))).toEqual([])

      const plans = await page.evaluate(smallInPlans)
      expect(Object.keys(plans)).toHaveLength(planned.length)
      const hard = Object.entries(plans).filter(
        ([, { least, wrong }]) => least < leastOfPlans || wrong.length > 0,
      )
      expect(hard.map(([at, plan]) => [printed[Number(at)]!.id, plan])).toEqual([])

      const pages = await readOutside(await page.pdf({ preferCSSPageSize: true, tagged: true }))
      const begins = pages.flatMap(({ headings }, at) => (headings.includes(1) && at > 0 ? [at + 1] : []))
      const sizes = printed.map(({ id, kind }, at) => {
        const own = pages.slice(begins[at]! - 1, (begins[at + 1] ?? Infinity) - 1)
        return { id, kind, sizes: own.map(({ width, height }) => `${width} × ${height}`) }
      })
      expect(sizes.filter(({ kind }) => kind === 'plan')).toEqual(planned)
      // A cover of so many lines has pages of its own.
      const named = (numbers: readonly number[]) =>
        printed.map(({ id }, at) => `${id}: page ${numbers[at]! - numbers[0]!}`)
      expect(named(begins)).toEqual(named(await beginnings(page)))
    })
  })
