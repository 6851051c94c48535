// Rooms: home, content
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { languages } from '../words.ts'

const beds = ['home.networkTitle', 'home.qTitle', 'home.sortingTitle']

/** The cards of a bed, the next one first. */
const cardsOf = (child: Child, bed: string) =>
  child.page
    .getByRole('article')
    .filter({ has: child.page.getByRole('heading', { name: child.word(bed), exact: true }) })
    .getByRole('link')

test.describe('by finger', () => {
  test.use({ hasTouch: true, viewport: { width: 1024, height: 768 } })

  // By keys the first of each bed is opened and solved by beds.spec.ts.
  test('three cards of each bed are a tap away, in both languages by turns', async ({ child }) => {
    await child.opensHome()
    for (const bed of beds)
      for (const index of [0, 1, 2]) {
        await child.speaks(child.language === 'en' ? 'de' : 'en')
        const card = cardsOf(child, bed).nth(index)
        const href = await card.getAttribute('href')
        await card.tap()
        await expect(child.page).toHaveURL(new RegExp(`${href}$`))
        await child.seesTitle()
        await child.page.goBack()
        await expect(card).toBeVisible()
      }
  })
})

test('the free lab is reached by keys, and begins empty under a name', async ({ child, page }) => {
  await child.opensHome()
  await child.tabsTo(page.getByRole('button', { name: child.word('home.free') }))
  await child.types('Enter')
  await expect(page.getByLabel(child.word('projects.name'), { exact: true })).toBeFocused()
  await child.types(...'Maze', 'Enter')
  await child.seesLab()
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Maze')
  await expect(child.canvas.locator('.blocklyDraggable')).toHaveCount(1)
})

const sizes = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]
/** What home leads to besides the cards of its beds. */
const places = { maps: 'maps', race: 'race', zoo: 'zoo', sorting: 'sorting' }

for (const viewport of sizes)
  test.describe(`at ${viewport.width} px`, () => {
    test.use({ hasTouch: true, viewport })

    test('no card of any chapter cuts off its dots, its number or its picture', async ({ child, page }) => {
      await child.opensHome()
      for (const language of ['de', 'en'] as const) {
        await child.speaks(language)
        const title = page.getByRole('heading', { name: child.word('home.networkTitle'), exact: true })
        const bed = page.getByRole('article').filter({ has: title })
        for (const chapter of ['home.byHand', 'home.fromExamples', 'home.byTrying']) {
          await child.presses(chapter)
          const cards = bed.getByRole('listitem')
          await expect(cards.first()).toBeVisible()
          const faults = await cards.evaluateAll((all) =>
            all.flatMap((card) => {
              const foot = card.querySelector('.foot')!
              const [dots, number] = [...foot.children].map((one) => one.getBoundingClientRect())
              const picture = card.querySelector('.picture')!
              const isCut = foot.scrollWidth > foot.clientWidth || dots!.right + 2 > number!.left
              const isStretched = picture.clientHeight > 1.2 * picture.clientWidth
              return isCut || isStretched ? [card.textContent] : []
            }),
          )
          expect(faults, `${language} ${chapter}`).toEqual([])
        }
      }
    })

    const ways = viewport.width === 1366 ? (['finger', 'keys'] as const) : (['finger'] as const)
    test(`maps, races, the zoo and sorting are reached by ${ways.join(' and by ')}`, async ({
      child,
      page,
    }) => {
      await child.opensHome()
      for (const [name, address] of Object.entries(places))
        for (const way of ways) {
          const place = page.getByRole('link', { name: child.word(`home.${name}`), exact: true })
          if (way === 'finger') await place.tap()
          else {
            await child.tabsTo(place)
            await child.types('Enter')
          }
          await expect(page).toHaveURL(new RegExp(`/${address}$`))
          await child.seesTitle()
          await page.goBack()
          await expect(place).toBeVisible()
        }
    })

    if (viewport.width >= 1024)
      test('everything is in sight without scrolling, in every language', async ({ child, page }) => {
        await child.opensHome()
        for (const language of languages) {
          await child.speaks(language)
          await expect(page.locator('html')).toHaveAttribute('lang', language)
          const below = page.getByRole('main').locator('a, button')
          const bottoms = await below.evaluateAll((all) =>
            all.map((one) => one.getBoundingClientRect().bottom),
          )
          expect(Math.max(...bottoms)).toBeLessThanOrEqual(viewport.height)
        }
      })
  })
