// Rooms: parts
import { leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensCard } from '../navigation.ts'
import { wordNet } from '../projects.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`what Botgarten says in ${language}`, () => {
    test.use({ language })

    test('to a child whose kept project cannot be read: it stays, and a new start is kept beside it', async ({
      child,
      page,
    }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      const kept = () =>
        page.evaluate(async () => {
          const database = await new Promise<IDBDatabase>((done) => {
            const request = indexedDB.open('botgarten')
            request.onsuccess = () => done(request.result)
          })
          const store = database.transaction('projects', 'readwrite').objectStore('projects')
          const all = await new Promise<{ id: string; project: number | { name: unknown } }[]>((done) => {
            const request = store.getAll()
            request.onsuccess = () => done(request.result as never)
          })
          for (const one of all) if (one.id === 'friendship') store.put({ ...one, project: 7 })
          database.close()
          return all.map(({ id, project }) => [id, typeof project === 'number' ? project : project.name])
        })
      await kept()

      await opensCard(child, 'friendship')
      const dialog = child.dialog('session.brokenHere')
      await expect(dialog).toContainText(child.word('session.brokenHereText'))
      await dialog.getByRole('button', { name: child.word('parts.ok') }).click()
      await child.typesWeight(rightEye, rightWheel, 0.6)
      await child.seesSaved()
      await child.reloads()
      await expect(dialog).toBeHidden()
      await child.seesWeight(rightEye, rightWheel, 0.6)
      await child.seesWeight(leftEye, leftWheel, 0)
      await expect.poll(kept).toEqual([
        ['friendship', 7],
        [expect.stringMatching(/^friendship-/), 'friendship'],
      ])
    })

    test('when Bo bumps into something on a card', async ({ child }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 1)
      await child.typesWeight(leftEye, rightWheel, 1)
      await child.typesWeight(rightEye, leftWheel, 1)
      await child.typesWeight(rightEye, rightWheel, 1)
      await child.pressesStart()
      await expect(child.words('session.bumped')).toBeVisible()
      await child.pressesStop()
      await child.presses('lab.resetWorld')
      await child.pressesStart()
      await expect(child.words('session.bumped')).toBeHidden()
    })

    test('for a word neuron that is not above 0', async ({ child, page }) => {
      await child.opensProjectAtHome('Word', wordNet('Word', 'Hurra'))
      await child.pressesStart()
      const display = async () => (await child.painted.place('bo badge display')).text
      await expect.poll(display).toContain(child.word('neuron.empty'))
      await child.knobs.first().focus()
      await child.types('End')
      await expect.poll(display).toContain('Hurra')
      await expect(page.locator('pre').filter({ hasText: 'Hurra' })).toHaveCount(1)
    })

    test.describe('when the picture of the floor does not come', () => {
      test.use({ complaints: [/ERR_FAILED/] })

      test('a card still runs', async ({ child, page }) => {
        await page.route(/floor[^/]*\.png$|\.pixels$/, (route) => route.abort())
        await child.opensLab('friendship')
        await expect(child.words('session.floorMissing')).toBeVisible()
        await child.typesWeight(leftEye, leftWheel, 0.8)
        await child.pressesStart()
        await child.seesDriving()
      })
    })
  })
}
