import { readPdf } from '../pdf.ts'
import { expect, follows, test, title } from './gate.ts'

test.use({ language: 'en' })

const ready = '.material[aria-busy="false"]'

test(
  'a card is found among the materials, read with its hints, and printed on a page of its own size',
  {
    tag: ['@materials', '@/materials', '@/materials/[kind]/[id]'],
  },
  async ({ child, page }) => {
    await follows(child, 'home.materials')
    const tiles = page.locator('.library li')
    const count = page.locator('.library').getByRole('status')
    const all = await count.textContent()
    await page.getByRole('searchbox').fill('NN 5')
    await expect(tiles.first().getByRole('heading')).toHaveText(child.card('friendship'))
    await expect(count).not.toHaveText(all!)
    await page.getByRole('checkbox', { name: child.word('materials.wayName.unsupervised') }).check()
    await expect(tiles).toHaveCount(0)
    await child.presses('materials.takeAway')
    await expect(count).toHaveText(all!)

    await page.getByRole('searchbox').fill('NN 5')
    await page
      .getByRole('heading', { level: 2, name: child.card('friendship') })
      .first()
      .click()
    await expect(title(page)).toHaveText(child.card('friendship'))
    await expect(page.locator(ready)).toBeVisible()
    const hints = page.locator('.hints > li')
    const seen = () => hints.evaluateAll((some) => some.filter((one) => one.checkVisibility()).length)
    await expect.poll(seen).toBe(0)
    await child.presses('materials.askHint', { number: 1, of: 3 })
    await expect.poll(seen).toBe(1)
    await page.goto('/materials/card/friendship?paper=a5')
    await expect(page.locator('html[data-print=ready] .paper')).toBeVisible()
    const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
    // Front and back of a card of A5.
    expect(pages.map(({ width, height }) => `${width} × ${height}`)).toEqual(['148 × 210', '148 × 210'])
    expect(pages[0]!.text).toContain(child.card('friendship'))
  },
)

test(
  'a set for a lesson is counted, slides are turned by keys, and a question says why',
  {
    tag: ['@materials', '@/materials', '@/materials/[kind]/[id]'],
  },
  async ({ child, page }) => {
    await follows(child, 'home.materials')
    await page.getByRole('searchbox').fill('NN 5')
    await child.presses('materials.set.put', { title: child.card('friendship') })
    const mySet = page.getByRole('region', { name: child.word('materials.set.title') })
    // A card for each of twelve pairs, two on a sheet.
    await expect(mySet.getByRole('status')).toContainText(child.word('materials.set.sheets', { sheets: 6 }))

    await page.goto('/materials/slides/teach-your-robot')
    await expect(page.locator(ready)).toBeVisible()
    await child.presses('materials.present')
    const at = (number: number) => page.getByText(child.word('materials.slideOf', { number, of: 19 }))
    await expect(at(1)).toBeVisible()
    await child.types('ArrowRight', 'ArrowRight')
    await expect(at(3)).toBeVisible()

    await page.goto('/materials/questions/1')
    await expect(page.locator(ready)).toBeVisible()
    await page.locator('.answers button').first().click()
    // The first answer to the first question is the right one.
    await expect(page.locator('.why')).toContainText(child.word('materials.guessed'))
  },
)
