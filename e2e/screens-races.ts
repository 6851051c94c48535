import { expect } from '@playwright/test'
import type { Child } from './child.ts'
import { racesFour } from './child-racing.ts'
import type { Screen } from './screens.ts'

const cliff = async (child: Child) => {
  await child.page.goto('/race?map=cliff')
  await expect(child.button('race.start')).toBeVisible()
}

async function races(child: Child) {
  await cliff(child)
  await child.page.getByRole('radio', { name: child.word('race.criterion.falls') }).check()
  await child.presses('race.start')
  await expect(child.page.getByRole('table').first()).toBeVisible()
}

/** Through the first door of every room, so often. */
async function walks(child: Child, moves: number) {
  await child.page.goto('/race?map=forest&you')
  const doors = child.page.getByRole('button', { name: new RegExp(`^${child.word('race.doorTo')}`) })
  for (let move = 0; move < moves; move++) await doors.first().click()
}

/** The short way of the forest, three times. */
async function finishes(child: Child) {
  await child.page.goto('/race?map=forest&you')
  for (let round = 0; round < 3; round++)
    for (const room of [2, 3, 5, 7]) {
      const name = new RegExp(`^${child.word('race.doorTo')} ${room} `)
      await child.page.getByRole('button', { name }).click()
    }
  await expect(child.button('race.playAgain')).toBeVisible()
}

const brains = async (child: Child) => {
  await child.page.goto('/race?brains=garden')
  await expect(child.button('race.brains.ready')).toBeVisible()
}

async function billed(child: Child) {
  await brains(child)
  await racesFour(child)
  await child.presses('race.brains.startNumber', { number: 3 })
}

/** Races, and a child who walks against Bo. */
export const raceScreens: readonly Screen[] = [
  { name: 'race-empty', show: cliff },
  { name: 'race', show: races },
  { name: 'race-brains-empty', show: brains },
  { name: 'race-brains', show: billed },
  { name: 'you-against-bo', show: (child) => walks(child, 3) },
  { name: 'you-against-bo-end', show: finishes },
]
