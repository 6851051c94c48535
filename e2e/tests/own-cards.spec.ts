// Rooms: own-cards
import { CardMaker } from '../child-own-cards.ts'
import { solves, tasks } from '../child-solving.ts'
import { TimeHands } from '../child-time.ts'
import { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { languagesOf } from '../words.ts'

const friendship = tasks.find(({ card }) => card.id === 'friendship')!

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a card of one's own in ${language}`, () => {
    test.use({ language })

    test('a teacher makes it, Bo proves it, a child opens and solves it', async ({ child, browser }) => {
      const maker = new CardMaker(child)
      await maker.begins()
      await expect(child.button('cards.saveFile')).toHaveAttribute('aria-disabled', 'true')
      await maker.writes()
      await maker.seesSolved(3, 3)
      await expect(child.words('cards.canShare')).toBeVisible()
      // By keys, a little aside: Bo tries it again.
      const place = child.button('cards.place', { number: 1 })
      await place.focus()
      await child.types('ArrowRight', 'ArrowUp', ',')
      await maker.seesSolved(3, 3)
      const file = await maker.saves()

      const context = await browser.newContext({ locale: language })
      const pupil = new Child(await context.newPage(), language)
      await pupil.opensHome()
      await pupil.opensFileAtHome('card.botgarten.json', file)
      await pupil.seesLab()
      await expect(pupil.page.getByRole('heading', { level: 1 })).toHaveText(maker.title)
      await expect(pupil.page.getByText('Bo stops near the square.')).toBeVisible()
      await pupil.presses('lab.hint')
      await expect(pupil.page.getByText('What do the eyes see?')).toBeVisible()
      await solves(pupil, friendship)
      await pupil.pressesStart()
      await new TimeHands(pupil).hurries()
      await expect(pupil.words('lab.successTitle').first()).toBeVisible({ timeout: 60_000 })
      await pupil.seesSaved()
      await pupil.reloads()
      await expect(pupil.button('lab.placePassed', { number: 1 })).toBeVisible()
      await context.close()
    })

    test('a hostile card is refused, and the child is told why', async ({ child, page }) => {
      await opensFromHome(child, 'home.materials')
      await page.getByRole('link', { name: child.word('parts.myCards'), exact: true }).click()
      const card = { text: { en: { title: '<script>', story: 'x', task: 'x', hints: ['x', 'x', 'x'] } } }
      await child.opensFileAtHome(
        'card.botgarten.json',
        JSON.stringify({ botgarten: 'card', version: 1, card }),
      )
      await expect(child.words('problem.notACard.title')).toBeVisible()
    })
  })
}
