// Rooms: study, lab, app, storage
import { leftEye, leftWheel } from '../child.ts'
import { StudyHands, replayed, studyFile } from '../child-study.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

for (const language of languagesOf(import.meta.filename))
  test.describe(`a study in ${language}`, () => {
    test.use({ language })

    test('a child says yes, drives, pauses and ends; its log is replayed to the same hashes', async ({
      child,
      page,
    }) => {
      const hands = new StudyHands(child)
      await hands.comes()
      await hands.opens()
      await expect(child.button('study.handOut')).toHaveAttribute('aria-disabled', 'true')
      await page.getByLabel(child.word('study.consentBox')).check()
      await child.presses('study.handOut')
      await page.getByLabel(child.word('study.number')).fill('0102A')
      await child.presses('study.yes')
      await expect(child.words('study.wrongNumber')).toBeVisible()
      await hands.begins(1, 2)

      await hands.opensCard('friendship')
      await expect(child.words('study.writes')).toBeVisible()
      await child.pressesStart()
      await child.typesWeight(leftEye, leftWheel, 0.8)
      await child.seesDriving()
      await child.presses('study.rest')
      await expect(child.words('study.rests')).toBeVisible()
      await child.typesWeight(leftEye, leftWheel, 0.3)
      await child.presses('study.wake')
      await expect(child.words('study.writes')).toBeVisible()
      await child.pressesStart()
      await child.seesDriving()
      await child.pressesStop()
      await hands.ends()

      await hands.saysWord()
      const { path, text } = await hands.takesLogs()
      const events = text.split('\n').flatMap((line) => /"event":"(\w+)"/.exec(line)?.[1] ?? [])
      expect(events.filter((event) => event === 'rest')).toHaveLength(1)
      expect(events.at(-1)).toBe('over')
      // What was turned while the log rested is in no line of its own.
      const between = events.slice(events.indexOf('rest') + 1, events.lastIndexOf('open'))
      expect(between).toEqual([])
      const { runs, pupils } = replayed(path)
      expect(runs.length).toBeGreaterThanOrEqual(2)
      expect(runs.every(({ same, ticks }) => same && ticks > 0)).toBe(true)
      expect(pupils).toMatchObject([{ pseudonym: '0102X', tries: 2, knobs: 1 }])
    })
  })

test('cards, blocks, maps and the order of parts are locked until the researcher ends the study', async ({
  child,
  page,
}) => {
  const hands = new StudyHands(child)
  await hands.handsOut()
  await hands.begins(2, 3, 'no')
  for (const closed of ['/lab/fear', '/lab/free', '/zoo', '/projects', '/']) {
    // By address: links to pages that a study locks.
    await page.goto(closed)
    await expect(page).toHaveURL(/\/study$/)
  }
  await hands.opensCard('friendship')
  await expect(child.words('study.nothing')).toBeVisible()
  await hands.goesBack()
  await child.presses('study.next')
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('study.sure') })
    .click()
  // By address: links to pages that a study locks.
  await page.goto('/lab/friendship')
  await expect(page).toHaveURL(/\/study$/)
  await hands.opensCard('fear')
  await hands.ends()

  await hands.saysWord('wrong')
  await expect(child.words('study.wrongWord')).toBeVisible()
  await page.getByLabel(child.word('study.word'), { exact: true }).fill('Kiesel7')
  await child.presses('study.enter')
  await expect(child.words('study.logs')).toHaveCount(0)
  await child.presses('study.endStudy')
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('study.endStudy') })
    .click()
  await child.opensLab('fear')
})

test('each child has projects of its own, and all of a number can be deleted', async ({ child, page }) => {
  const hands = new StudyHands(child)
  await hands.handsOut()
  for (const [number, weight] of [
    [1, 0.8],
    [2, 0.4],
  ] as const) {
    await hands.begins(1, number)
    await hands.opensCard('friendship')
    await child.typesWeight(leftEye, leftWheel, weight)
    await child.seesSaved()
    await hands.ends()
  }
  await hands.saysWord()
  await child.presses('study.deleteOne', { pseudonym: '0101D' })
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('study.delete'), exact: true })
    .click()
  await expect(page.getByText('0101D')).toHaveCount(0)
  const { text } = await hands.takesLogs()
  expect(text).toContain('"0102X"')
  expect(text).not.toContain('0101D')
  const kept = await page.evaluate(async () => {
    const databases = await indexedDB.databases()
    const all: unknown[] = []
    for (const { name } of databases) {
      const db = await new Promise<IDBDatabase>((resolve) => {
        const asked = indexedDB.open(name!)
        asked.onsuccess = () => resolve(asked.result)
      })
      for (const store of db.objectStoreNames) {
        const read = db.transaction(store).objectStore(store)
        for (const asked of [read.getAll(), read.getAllKeys()])
          all.push(await new Promise((resolve) => (asked.onsuccess = () => resolve(asked.result))))
      }
      db.close()
    }
    return JSON.stringify([all, { ...localStorage }])
  })
  expect(kept).toContain('0102X')
  expect(kept).not.toContain('0101D')
})

test('a study is planned by keys alone, saved as a file, and opened again; slips have its numbers', async ({
  child,
  page,
}) => {
  const hands = new StudyHands(child)
  await hands.comes()
  await child.tabsAndPresses('study.make')
  await child.tabsTo(page.getByLabel(child.word('study.titleOf')))
  await page.keyboard.type('Winter')
  await page.keyboard.press('Tab')
  await page.keyboard.type('Schnee')
  await child.tabsTo(child.button('study.saveFile'))
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')])
  expect(download.suggestedFilename()).toBe('Winter.json')
  await child.presses('study.slips')
  await expect(page.getByText('0101D').first()).toBeVisible()
  await expect(page.getByRole('listitem')).toHaveCount(30)
  await child.presses('study.back')
  await expect(page.getByLabel(child.word('study.titleOf'))).toHaveValue('Winter')
  await hands.comes()
  await page.locator('input[type=file]').setInputFiles(await download.path())
  await expect(page.getByRole('heading', { name: 'Winter' })).toBeVisible()
  // By address: another day the device opens the study again.
  await page.goto('/study')
  await child.presses('study.endStudy')
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('study.endStudy') })
    .click()
  await hands.opens(studyFile({ seed: -1 }))
  await expect(child.words('study.refused', { field: 'seed' })).toBeVisible()
})
