// Rooms: questionnaires, content
import { readFileSync } from 'node:fs'
import { unzipSync } from 'fflate'
import { study2020 } from '@botgarten/answers'
import { topics } from '@botgarten/content/questionnaires'
import { Asker, nth } from '../child-questionnaires.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'
import { givesVoice } from '../voice.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`questionnaires in ${language}`, () => {
    test.use({ language })

    test('a child of grade 5 answers, four come from a file; results come when it is closed', async ({
      child,
      page,
    }) => {
      const asker = new Asker(child)
      const { title } = asker.form('after').text[language]!
      await asker.comes()
      await asker.asks('after', 5)
      await asker.choosesCode('owl', 200)
      await asker.begins()
      await asker.fillsIn('after', false, nth(0))
      await asker.comes()
      await asker.takesFile('after', 5, [1, 2, 3, 4])
      await expect(child.words('form.takenAnswers', { count: 4 })).toBeVisible()
      // By address: no link leads to the results before the form is closed.
      await page.goto('/questionnaires?form=after&show=results')
      await expect(child.words('form.stillOpenText')).toBeVisible()
      await child.presses('form.close')
      const row = page
        .getByRole('row')
        .filter({ hasText: asker.form('after').text[language]!.words['supervised']!['label']! })
      await expect(row.first()).toContainText(language === 'de' ? '3,00' : '3.00')
      await expect(row.first()).toContainText(language === 'de' ? '4,57' : '4.57')
      await expect(page.getByText('Bo 🌱🌱🌱', { exact: true })).toHaveCount(3)

      const [file] = await Promise.all([
        page.waitForEvent('download'),
        page.getByRole('button', { name: 'CSV' }).click(),
      ])
      expect(file.suggestedFilename()).toBe(`${title}.zip`)
      const tables = unzipSync(readFileSync(await file.path()))
      expect(Object.keys(tables).sort()).toEqual([
        ...['after-counts.csv', 'after-take-along.csv', 'after-what-ai.csv', 'after-what-ml.csv'],
        ...['after.csv', 'code-book.csv'],
      ])
      const rows = new TextDecoder().decode(tables['after.csv']).trim().split('\r\n')
      expect(rows).toHaveLength(6)
      expect(rows.join()).not.toMatch(/owl|20\d\d-/)
    })
  })

test('four answers are shown nowhere, and a fifth from a file opens them', async ({ child, page }) => {
  const asker = new Asker(child)
  await asker.comes()
  await asker.asks('before', 8)
  await asker.choosesCode('robin', 300)
  await asker.begins()
  await asker.fillsIn('before', false, nth(0))
  await child.presses('form.nextChild')
  await asker.choosesCode('robin', 300)
  await expect(child.words('form.codeTaken')).toBeVisible()
  await asker.comes()
  await asker.takesFile('before', 8, [1, 2, 3])
  await child.presses('form.close')
  await expect(child.words('form.few')).toBeVisible()
  await asker.opens('before', 'form.results')
  await expect(child.words('form.fewText')).toBeVisible()

  await asker.comes()
  const [saved] = await Promise.all([page.waitForEvent('download'), child.presses('form.saveFile')])
  const file = JSON.parse(readFileSync(await saved.path(), 'utf8')) as { answers: object[] }
  const fifth = { ...file.answers[0], id: 'f'.repeat(32), code: null }
  const text = JSON.stringify({ ...file, answers: [...file.answers, fifth] })
  const choose = { name: 'answers.json', mimeType: 'application/json', buffer: Buffer.from(text) }
  await page.locator('input[type=file]').setInputFiles(choose)
  await expect(child.words('form.takenAnswers', { count: 1 })).toBeVisible()
  await expect(child.words('form.answers', { count: 5 })).toBeVisible()

  await child.presses('form.delete')
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('form.delete') })
    .click()
  await expect(child.words('form.answers', { count: 5 })).toHaveCount(0)
})

test('in grade 3 there is one question a screen with five faces, and each is read aloud', async ({
  child,
  page,
}) => {
  await givesVoice(page, ['en-GB'])
  const asker = new Asker(child)
  await asker.comes()
  await asker.asks('after', 3)
  await child.presses('form.codeForgot')
  await expect(child.words('form.questionOf', { number: 1, of: 13 })).toBeVisible()
  await child.presses('form.readAloud')
  const said = await page.evaluate(() => (window as unknown as { heard: { said: string[] } }).heard.said)
  expect(said.at(-1)).toContain('very uninteresting. uninteresting. so-so. interesting. very interesting.')
  await asker.fillsIn('after', true, nth(3))
})

test('counts from paper stand in the results, and too many of an item are refused', async ({
  child,
  page,
}) => {
  const asker = new Asker(child)
  await asker.comes()
  await asker.opens('after', 'form.typeIn')
  await page.getByLabel(child.word('form.sheets'), { exact: true }).fill('7')
  const question = asker.form('after').text['en']!.words['go-on']!
  const group = page.getByRole('group', { name: question['question']! })
  await group.getByLabel(question['yes']!, { exact: true }).fill('8')
  await expect(child.words('form.tooMany')).toBeVisible()
  await group.getByLabel(question['yes']!, { exact: true }).fill('5')
  await group.getByLabel(question['maybe']!, { exact: true }).fill('2')
  await child.presses('form.addTyped')
  await expect(child.words('form.answers', { count: 7 }).first()).toBeVisible()
  await expect(page.getByText('5 (71.4%)')).toBeVisible()
})

test('a teacher copies a form, leaves questions out, adds one and asks it', async ({ child, page }) => {
  const asker = new Asker(child)
  await asker.comes()
  await asker.opens('after', 'form.copy')
  await page.getByLabel(child.word('form.formTitle'), { exact: true }).fill('Our project day')
  for (const box of (await page.getByRole('checkbox').all()).slice(1)) await box.uncheck()
  await child.presses('form.addText')
  await page
    .getByRole('textbox', { name: child.word('form.question') })
    .last()
    .fill('What was funny?')
  await child.presses('form.saveForm')
  const card = page.getByRole('article').filter({ hasText: 'Our project day' })
  await card.getByRole('button', { name: child.word('form.ask'), exact: true }).click()
  await child.presses('form.codeForgot')
  await expect(page.getByText('1 of 2', { exact: true })).toBeVisible()
  await child.presses('form.next')
  await page.getByRole('textbox', { name: 'What was funny?' }).fill('Bo danced')
  await child.presses('form.done')
  await expect(child.words('form.thanks')).toBeVisible()
})

test('the tables of 2020 are shown without a single answer', async ({ child, page }) => {
  const asker = new Asker(child)
  await asker.comes()
  await page.getByRole('link', { name: child.word('form.study2020Show'), exact: true }).click()
  const decimal = (value: number) =>
    value.toLocaleString(child.language, { minimumFractionDigits: 1, maximumFractionDigits: 2 })
  const tables = page.getByRole('table')
  await expect(tables).toHaveCount(3)
  for (const [index, scale] of (['interest', 'ease'] as const).entries())
    for (const [row, group] of study2020.entries()) {
      const cells = tables
        .nth(index)
        .getByRole('row')
        .nth(row + 1)
        .getByRole('cell')
      const { supervised, unsupervised, reinforcement } = group[scale]
      const means = topics.map((topic) => decimal({ supervised, unsupervised, reinforcement }[topic]))
      await expect(cells).toHaveText([...means, String(group.n)])
    }
  const percent = (share: number) => share.toLocaleString(child.language, { style: 'percent' })
  await expect(tables.nth(2).getByRole('row').last().getByRole('cell')).toHaveText([
    ...[percent(0.75), percent(0.25), percent(0)],
    '24',
  ])
})
