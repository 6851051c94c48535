import type { Card } from '@botgarten/content'
import { expect } from '@playwright/test'
import type { Child } from './child.ts'

/** Is a card about a race of four brains? */
export const isRaced = ({ card }: { readonly card: Card }): boolean =>
  card.checks.some(({ kind }) => kind === 'raced')

/** From the lab to the race of four brains, through it, both questions answered, and back to the lab. */
export async function racesBrains(child: Child) {
  await child.presses('lab.raceBrains')
  await racesFour(child)
  for (const question of ['trust', 'explain']) {
    const group = child.page.getByRole('group', { name: child.word(`race.brains.ask.${question}`) })
    await child.press(group.getByRole('radio', { name: child.word('race.brains.lane.ifThen') }))
  }
  await expect(child.page.getByText(child.word('race.brains.answered')).locator('..')).toContainText(
    child.word('race.brains.answered') + child.word('race.brains.isDone'),
  )
  await child.press(child.page.getByRole('link', { name: child.word('race.brains.back') }))
  await child.seesLab()
}

/** All four race; the bill is there. */
export async function racesFour(child: Child) {
  await child.presses('race.brains.ready')
  await expect(child.page.getByRole('table').getByRole('row')).toHaveCount(10, { timeout: 120_000 })
}
