// Rooms: senses
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { parseProject } from '@botgarten/programs'
import { expect, test } from '../house.ts'

/** The script that learns. */
const worker = /\/night-worker[^/]*\.js$/

test('Bo learns overnight what Node learns, bit for bit, keeps it, and drives by it', async ({
  child,
  page,
}) => {
  const { card, world } = content.card('try-dodge')!
  const { tables, ...program } = content.program('try-dodge', 'solution')!
  const project = cardProject(world, card, program, 'Night')
  await child.opensLab('try-dodge')
  await child.opensProject('Night', JSON.stringify(project))

  // A fast machine would be through before the button is pressed: this night waits for its worker.
  await page.route(worker, () => {})
  await child.presses('night.begin')
  await child.presses('night.stop')
  await expect(page.getByText(child.word('night.stopped'))).toBeVisible()
  await page.unroute(worker)
  await child.presses('night.begin')
  await expect(page.getByRole('figure', { name: child.word('night.curves') }).getByRole('row')).toHaveCount(
    9,
    {
      timeout: 60_000,
    },
  )
  await expect(child.button('night.stop')).toBeHidden()
  // Every move has been tried: no count of untried moves follows the number of states.
  await expect(page.locator('.size')).toHaveText(
    child.word('senses.sizeBump', { product: '3 × 3', states: 10 }),
  )

  const saved = await child.savesFile()
  expect(JSON.parse(saved)).toMatchObject({ botgarten: 4, brains: { try: { kind: 'table' } } })
  const { curve, ...learned } = parseProject(saved).tables!['try']!
  expect({ try: learned }).toEqual(tables)
  expect(curve).toHaveLength(8)
  await child.seesSaved()
  await page.reload()
  await expect(page.getByRole('figure', { name: child.word('night.curves') }).getByRole('row')).toHaveCount(9)
  await child.pressesStart()
  await child.seesDriving()
})
