// Rooms: projects, storage
import type { Project } from '@botgarten/programs'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

const read = (text: string) => JSON.parse(text) as Project

/** Names of all projects that home offers. */
const offered = (child: Child) => child.page.locator('a.tile:not([href$="/lab/free"]) b').allTextContents()

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`project files, in ${language}`, () => {
    test.use({ language })

    test('a saved file opens as it was, from the lab and from home', async ({ child }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.45)
      await child.asksHint()
      await child.addsNeuron('addMotor')
      await expect(child.knobs).toHaveCount(6)
      await child.seesSaved()
      const [words, file] = [await child.blockWords(), await child.savesFile()]

      await child.typesWeight(leftEye, leftWheel, 0.9)
      await child.opensFile('mine.botgarten.json', file)
      await child.seesWeight(leftEye, leftWheel, 0.45)
      await expect.poll(() => child.blockWords()).toEqual(words)
      expect(read(await child.savesFile())).toEqual(read(file))

      await child.opensHome()
      await child.opensFileAtHome('mine.botgarten.json', file)
      await child.seesWeight(leftEye, leftWheel, 0.45)
      await child.seesWeight(rightEye, rightWheel, 0)
      expect(read(await child.savesFile())).toEqual(read(file))

      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.9)
    })

    test('home leads to every project that was opened, the last one first', async ({ child }) => {
      const names = ['Uno', 'Due', 'Tre', 'Quattro', 'Cinque']
      for (const name of names) {
        await child.opensHome()
        await child.opensFileAtHome(
          `${name}.json`,
          freeProgram(name, (make) => [make.wait(names.indexOf(name))]),
        )
        await expect(child.page.getByRole('heading', { level: 1 })).toHaveText(name)
      }
      await child.opensHome()
      const said = names
        .toReversed()
        .map((name, index) => (index < 1 ? child.word('home.continue', { name }) : name))
      await expect.poll(() => offered(child)).toEqual(said)
      await child.page.getByRole('link', { name: /^Uno/ }).click()
      await expect(child.page.getByRole('heading', { level: 1 })).toHaveText('Uno')
      await expect(child.block('b1')).toBeVisible()
    })
  })
}
