// Rooms: races, teacher
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, teaches, type Joined } from '../made-class.ts'
import { languagesOf } from '../words.ts'

const test = testInClass()

/** Shares the solution of a card, as another device would. */
async function shares({ asker }: Joined, id: string, title: string) {
  const { card, world } = content.card(id)!
  const project = cardProject(world, card, content.program(id, 'solution')!, title)
  const { status } = await asker.ask('POST', `/gallery?share=share-of-${id}`, project)
  expect(status).toBe(201)
}

for (const language of languagesOf(import.meta.filename))
  test.describe(`the race of brains of a class, in ${language}`, () => {
    test.use({ language })

    test('from the wall a teacher opens it with what the class has shared, and comes back', async ({
      child,
      page,
      school,
    }) => {
      const [owl, fox] = [await joins(school, 'Eule'), await joins(school, 'Fuchs')]
      await shares(owl, 'try-dodge', 'My coins')
      await shares(fox, 'four-brains', 'My rules')
      await teaches(page, school)
      // By address: a teacher comes by a bookmark.
      await page.goto(`/teacher/projector?class=${school.id}`)
      await page.getByRole('link', { name: child.word('teacher.brainRace'), exact: true }).click()
      const lane = (kind: string) =>
        page
          .getByRole('combobox', {
            name: new RegExp(`^${child.word(`race.brains.lane.${kind}`).replace(/[()]/g, '.')}`),
          })
          .locator('option:checked')
      const shared = (name: string, by: string) => child.word('race.brains.shared', { name, by })
      await expect(lane('trying')).toHaveText(shared('My coins', 'Eule'))
      await expect(lane('ifThen')).toHaveText(shared('My rules', 'Fuchs'))
      await expect(lane('hand')).toHaveText(child.word('race.brains.given'))
      await page.getByRole('link', { name: child.word('race.brains.toClass'), exact: true }).click()
      await expect(page).toHaveURL(/teacher\/projector/)
    })
  })
