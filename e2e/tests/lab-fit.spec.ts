// Rooms: editor, world, app
import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { expect, test } from '../house.ts'
import { fitOf } from '../lab-fit.ts'
import { sampled } from '../variant.ts'

// German words are the longest. A map fills the lab, and its program is folded.
test.use({ language: 'de' })

const cards = content.cards.filter(({ bed }) => bed !== 'q-learning').map(({ id }) => id)
/** A network with layers between is panned where there is little height. */
const isPanned = (card: string) => {
  const start = new URL(`../../content/${content.cardFolder(card)}/start.json`, import.meta.url)
  return readFileSync(start, 'utf8').includes('ai_nn_hidden_layer')
}
const sizes = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
]

test('on every card Bo is 44 px wide, blocks and network are whole, and nothing lies over blocks or their list', async ({
  child,
  page,
}) => {
  test.slow()
  for (const [turn, card] of sampled(cards).entries())
    // It is opened at one of the sizes, by turns, and fits into the other when the window changes.
    for (const [face, size] of (turn % 2 === 0 ? sizes : sizes.toReversed()).entries()) {
      await page.setViewportSize(size)
      if (face === 0) await child.opensLab(card)
      else await child.watches(3)
      const fit = async () => {
        const { bo, over, cut, ...fit } = await fitOf(page)
        const pans = isPanned(card) ? 0 : fit.pans
        return { card, width: size.width, small: Math.round(bo ?? 0) < 44, over, cut: Math.round(cut), pans }
      }
      await expect.poll(fit).toEqual({ card, width: size.width, small: false, over: [], cut: 0, pans: 0 })
    }
})

test('a hint has room of its own, and an open list leaves its buttons free', async ({ child, page }) => {
  await child.opensLab('chameleon')
  await child.presses('lab.hint')
  await expect(page.getByRole('region', { name: child.word('lab.hint') })).toBeVisible()
  await expect.poll(async () => (await fitOf(page)).over).toEqual([])
})

test('a long name leaves the bar of a phone in one row, and the task below it free', async ({
  child,
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await child.opensLab('chameleon')
  await page.getByTitle(child.word('lab.rename')).click()
  await page
    .getByRole('textbox', { name: child.word('lab.rename') })
    .fill('Entweder, oder: geübt. '.repeat(3))
  await child.types('Enter')
  const outside = () =>
    page.locator('header.page-bar').evaluate((bar) => {
      const { top, bottom } = bar.getBoundingClientRect()
      return [...bar.querySelectorAll(':is(a, button):not(:scope [popover] *)')]
        .filter((one) => one.checkVisibility())
        .map((one) => ({
          name: one.getAttribute('title') ?? one.textContent.trim(),
          box: one.getBoundingClientRect(),
        }))
        .filter(({ box }) => box.top < top || box.bottom > bottom || box.right > innerWidth)
        .map(({ name }) => name)
    })
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 844 })
    await expect.poll(outside).toEqual([])
    await child.presses('lab.hint')
    await child.types('Escape')
  }
})
