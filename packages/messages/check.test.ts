import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, expect, test } from 'vitest'
import { sharesIn, wrongForms } from './check.ts'
import { filesIn } from './folder.ts'

const folder = mkdtempSync(join(tmpdir(), 'words-'))
afterAll(() => rmSync(folder, { recursive: true }))
const table = { one: '1', two: '2', three: '3' }
for (const [language, words] of Object.entries({ de: table, en: table, fr: { one: '1', two: '2' } })) {
  mkdirSync(join(folder, language))
  writeFileSync(join(folder, language, 'app.json'), JSON.stringify(words))
}
writeFileSync(join(folder, 'en', 'notes for translators.txt'), 'No messages.')

test('a share is rounded down: 100 % is a language that is complete', () => {
  expect(sharesIn(folder)).toEqual(['fr: 2 of 3 messages (66 %)'])
})

test('only JSON files are read as messages', () => {
  expect(filesIn(folder)).toEqual(['app'])
})

test('a sentence with two numbers needs a form for each pair of their plurals', () => {
  const message = (...forms: string[]) =>
    [
      {
        declarations: ['input a', 'input b', 'local aPlural = a: plural', 'local bPlural = b: plural'],
        selectors: ['aPlural', 'bPlural'],
        match: Object.fromEntries(forms.map((form) => [form, '{a} and {b}'])),
      },
    ] as const
  const [some, all] = ['aPlural=*, bPlural=one', 'aPlural=*, bPlural=*']
  expect(wrongForms('en', 'pair', message(some, all))).toEqual([])
  expect(wrongForms('en', 'pair', message(some))).toEqual([
    'pair in en: no form for one, other',
    'pair in en: no form for other, other',
  ])
})
