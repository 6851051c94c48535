import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { CardMaker } from '../child-own-cards.ts'
import { expect, opensProject, test, title } from './gate.ts'

test.use({ language: 'de' })

test(
  'a card is made of a project, Bo proves it, and whoever opens its file has the task',
  {
    tag: ['@own-cards', '@/cards'],
  },
  async ({ child, page }) => {
    const maker = new CardMaker(child)
    const { card, world } = content.card('friendship')!
    const project = cardProject(world, card, content.program('friendship', 'solution')!, 'Meins')
    await opensProject(child, 'Meins', JSON.stringify(project))
    await child.presses('lab.menu')
    await child.presses('parts.makeCard')
    await expect(child.button('cards.saveFile')).toHaveAttribute('aria-disabled', 'true')
    await maker.writes()
    await maker.seesSolved(3, 3)
    const file = await maker.saves()
    await page.goto('/cards')
    await expect(page.getByText(maker.title).first()).toBeVisible()
    await child.opensHome()
    await child.opensFileAtHome('card.botgarten.json', file)
    await child.seesLab()
    await expect(title(page)).toHaveText(maker.title)
    await expect(page.getByText('Bo stops near the square.')).toBeVisible()
    await expect(child.knobs.first()).toHaveAttribute('aria-valuenow', '0')
  },
)
