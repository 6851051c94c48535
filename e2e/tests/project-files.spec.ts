// Rooms: projects, storage
import type { Project } from '@botgarten/programs'
import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram, projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

const good = projectFile('friendship', 'start')
const read = (text: string) => JSON.parse(text) as Project

/** Files that are no project, and what is said about each. */
const refused = [
  { what: 'no JSON', text: '<xml/>', problem: 'notJson', facts: {} },
  { what: 'nothing at all', text: '', problem: 'notJson', facts: {} },
  { what: 'JSON of another shape', text: '{"botgarten":1,"name":"x"}', problem: 'notAProject', facts: {} },
  { what: 'a file of more than 5 MB', text: good.padEnd(5_000_001), problem: 'tooBig', facts: {} },
  { what: 'a newer version', text: '{"botgarten":7}', problem: 'newerVersion', facts: { version: 7 } },
  {
    what: 'a key that reaches into every object',
    text: good.replace('"programs":{', '"programs":{"__proto__":{"polluted":true},'),
    problem: 'notAProject',
    facts: {},
  },
  {
    what: 'a world without a robot',
    text: JSON.stringify({ ...read(good), world: { ...read(good).world, robots: [] } }),
    problem: 'notAProject',
    facts: {},
  },
] as const

async function isToldWhy(child: Child, problem: string, facts: object) {
  const dialog = child.dialog(`problem.${problem}.title`)
  await expect(dialog).toContainText(child.word(`problem.${problem}.text`, { ...facts }))
  await dialog.getByRole('button', { name: child.word('parts.ok') }).click()
  await expect(dialog).toBeHidden()
}

/** Names of all projects that home offers. */
const offered = (child: Child) => child.page.locator('a.tile:not([href$="/lab/free"]) b').allTextContents()

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`project files, in ${language}`, () => {
    test.use({ language })

    test('a broken file is refused with a reason, and nothing changes', async ({ child, page }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.45)
      for (const { what, text, problem, facts } of refused)
        await test.step(what, async () => {
          await child.opensFile('broken.json', text)
          await isToldWhy(child, problem, facts)
        })
      await child.seesWeight(leftEye, leftWheel, 0.45)
      expect(await page.evaluate(() => 'polluted' in {})).toBe(false)

      await child.opensHome()
      await child.opensFileAtHome('newer.json', '{"botgarten":7}')
      await isToldWhy(child, 'newerVersion', { version: 7 })
      expect((await offered(child)).filter((name) => name.includes(child.card('friendship')))).toHaveLength(1)
    })

    test('a saved file opens as it was, from the lab and from home', async ({ child }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.45)
      await child.presses('lab.hint')
      await child.presses('network.addMotor')
      await expect(child.knobs).toHaveCount(6)
      await child.seesSaved()
      const [words, file] = [await child.blockWords(), await child.savesFile()]

      await child.typesWeight(leftEye, leftWheel, 0.9)
      await child.opensFile('mine.botgarten.json', file)
      await child.seesWeight(leftEye, leftWheel, 0.45)
      expect(await child.blockWords()).toEqual(words)
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

    test('a project for a card that this version does not have opens in the free lab', async ({ child }) => {
      const strange = freeProgram('Chameleon', (make) => [make.wait(600_000)])
      await child.opensLab('friendship')
      await child.opensFile('chameleon.json', JSON.stringify({ ...read(strange), card: 'chameleon' }))
      await expect(child.page.getByRole('heading', { level: 1 })).toHaveText('Chameleon')
      await child.pressesStart()
      expect(read(await child.savesFile()).card).toBe('chameleon')
    })
  })
}
