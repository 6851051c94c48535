import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join, relative } from 'node:path'
import { fill, type Table } from '@botgarten/messages'
import { factsOf } from '@botgarten/messages/facts'
import { filesIn, languagesIn, ownTableOf } from '@botgarten/messages/folder'
import { compile } from '@inlang/paraglide-js'
import { expect, onTestFinished, test, vi } from 'vitest'
import { m } from '#words/message.ts'
import { language } from './language.svelte.ts'
import { hasMessage, message, wordsIn } from './message.ts'

const filesOfMessages = filesIn().filter((file) => file !== 'cli' && file !== 'blockly')

test('a message says its facts; a key that nobody wrote comes back', () => {
  const facts = { label: 'Abstand', place: 'links' }
  expect(wordsIn('de')('network.name', facts)).toBe('Abstand links')
  const told = vi.spyOn(console, 'error').mockImplementation(() => {})
  expect(message('nobody.wrote.this')).toBe('nobody.wrote.this')
  expect(told).toHaveBeenCalledOnce()
  expect([hasMessage('world.lost'), hasMessage('projects.renamed'), hasMessage('nobody.wrote.this')]).toEqual(
    [true, true, false],
  )
})

test('a message of the built product says its words in the language of now', async () => {
  await language.speak('de')
  expect(m['world.lost']()).toBe('Bo steckt fest.')
  await language.speak('en')
  expect(m['world.lost']()).toBe('Bo is stuck.')
})

/** Messages that change with a number, by their keys. */
const changingIn = (locale: string): Table =>
  Object.fromEntries(
    filesOfMessages
      .flatMap((file) => Object.entries(ownTableOf(file, locale)))
      .filter(([, message]) => typeof message !== 'string'),
  )

/** What Paraglide compiles of tables of messages, by language. */
async function compiledOf(tables: { readonly [locale: string]: Table }) {
  const folder = mkdtempSync(join(import.meta.dirname, 'generated/paraglide-'))
  onTestFinished(() => rmSync(folder, { recursive: true }))
  for (const [locale, table] of Object.entries(tables))
    writeFileSync(join(folder, `${locale}.json`), JSON.stringify(table))
  const plugin = createRequire(import.meta.url).resolve('@inlang/plugin-message-format')
  const settings = {
    ...{ baseLocale: 'en', locales: Object.keys(tables), modules: [relative(folder, plugin)] },
    'plugin.inlang.messageFormat': { pathPattern: './{locale}.json' },
  }
  const project = join(folder, 'project.inlang')
  mkdirSync(project)
  writeFileSync(join(project, 'settings.json'), JSON.stringify(settings))
  await compile({ project, outdir: join(folder, 'compiled'), strategy: ['baseLocale'] })
  return (await import(/* @vite-ignore */ join(folder, 'compiled/messages/_index.js'))) as {
    readonly [key: string]: (facts: object, options: { readonly locale: string }) => string
  }
}

test('a sentence with a number is what Paraglide compiles of it, in every language', async () => {
  const tables = Object.fromEntries(languagesIn().map((locale) => [locale, changingIn(locale)]))
  const compiled = await compiledOf(tables)
  const numbers = [0, 1, 2, 3, 5, 10, 11, 21, 22, 100, 101, 999, 1000, 1001, 12345]
  for (const [locale, table] of Object.entries(tables)) {
    expect(Object.keys(table).length).toBeGreaterThan(20)
    for (const [key, message] of Object.entries(table)) {
      const inputs = factsOf(message)
      for (const first of numbers)
        for (const second of [1, first]) {
          const facts = Object.fromEntries(inputs.map((name, at) => [name, at === 0 ? first : second]))
          expect(fill(message, facts, locale), `${key} in ${locale}`).toBe(compiled[key]!(facts, { locale }))
        }
    }
  }
})

test.each([
  ['sorting.readingCount', { count: 1 }, '1 Messwert', '1 reading'],
  ['q.byEpisodes', { count: 1 }, 'Der eine Versuch ist vorbei.', 'The one try is done.'],
  ['q.byEpisodes', { count: 1000 }, 'Alle 1.000 Versuche sind vorbei.', 'All 1,000 tries are done.'],
  ['projects.days', { days: 1 }, 'Letzter Tag', 'Last day'],
  ['home.level', { passed: 0, of: 1 }, '0 von 1 Platz geschafft', '0 of 1 place done'],
])('"%s" of %o has its singular where there is one', (key, facts, german, english) => {
  expect([wordsIn('de')(key, facts), wordsIn('en')(key, facts)]).toEqual([german, english])
})
