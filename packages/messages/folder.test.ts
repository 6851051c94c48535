import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { afterAll, expect, test } from 'vitest'
import { doubledIn, missingIn, sharesIn, unlikeIn } from './check.ts'
import { languagesIn, tableOf, wordsOf } from './folder.ts'
import { fill } from './message.ts'

const folder = mkdtempSync(join(tmpdir(), 'words-'))
afterAll(() => rmSync(folder, { recursive: true }))

function write(file: string, tree: object) {
  mkdirSync(dirname(join(folder, file)), { recursive: true })
  writeFileSync(join(folder, file), JSON.stringify(tree))
}
const days = (one: string, other: string) => [
  {
    declarations: ['input days', 'local daysPlural = days: plural'],
    selectors: ['daysPlural'],
    match: { 'daysPlural=one': one, 'daysPlural=other': other },
  },
]
write('en/app.json', { hello: 'Hello {name}', bin: { days: days('one day', '{days} days') } })
write('en/late.json', { more: 'More' })
write('de/app.json', {
  hello: 'Hallo {name}',
  bin: { days: days('ein Tag', '{days} Tage') },
  only: 'Nur hier',
})
write('de/late.json', { more: 'Mehr' })
// In French nothing is one too, in English it is not.
write('fr/app.json', { hello: 'Bonjour {nom}' })

test('a language is a folder', () => {
  expect(languagesIn(folder)).toEqual(['de', 'en', 'fr'])
})

test('what a language lacks is said in English, else in German, by the rules of that language', () => {
  const words = tableOf('app', 'fr', folder)
  expect(words['hello']).toBe('Bonjour {nom}')
  expect(words['only']).toBe('Nur hier')
  expect([0, 1, 2].map((days) => fill(words['bin.days']!, { days }, 'fr'))).toEqual([
    '0 days',
    'one day',
    '2 days',
  ])
  expect(wordsOf('fr', folder)['more']).toBe('More')
})

test('German and English have to be complete', () => {
  expect(missingIn(folder)).toEqual(['en lacks only (app.json)'])
})

test('any other language is listed with its share', () => {
  // hello; of hello, bin.days, only, more
  expect(sharesIn(folder)).toEqual(['fr: 1 of 4 messages (25 %)'])
})

test('facts that differ from those in English are named, in an incomplete language too', () => {
  expect(unlikeIn(folder)).toEqual(['hello has {name} in en and {nom} in fr'])
})

test('a message that stands in two files is named', () => {
  write('en/other.json', { more: 'More' })
  expect(doubledIn(folder)).toEqual(['more is there twice in en'])
})
