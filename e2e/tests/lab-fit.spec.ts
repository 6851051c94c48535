// Rooms: editor, world, app
import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { expect, test } from '../house.ts'
import { fitOf } from '../lab-fit.ts'

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
  for (const [turn, card] of cards.entries())
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
