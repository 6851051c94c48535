import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { formsOf } from '@botgarten/messages'
import { completeLanguages, wordsOf as allWordsOf } from '@botgarten/messages/folder'

const rooms = ['../../blocks', '..', '../../lab/recording', '../../lab/trying', '../../learning/q-senses']

function sources(folder: URL): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    if (entry.isDirectory()) return sources(new URL(`${entry.name}/`, folder))
    return /(?<!\.test)\.ts$/.test(entry.name) ? [readFileSync(new URL(entry.name, folder), 'utf8')] : []
  })
}

/** Said by the screens. */
const elsewhere = ['notKept']

const code = rooms.flatMap((room) => sources(new URL(`${room}/`, import.meta.url))).join('\n')
const screens = sources(new URL('../../../apps/web/src/', import.meta.url)).join('\n')

interface Said {
  readonly title: string
  readonly text: string
}

function wordsOf(language: string): readonly (readonly [string, Said])[] {
  const words = allWordsOf(language)
  const said = (name: string, part: string) => formsOf(words[`problem.${name}.${part}`] ?? '').join(' ')
  const names = Object.keys(words).flatMap((key) => /^problem\.(\w+)\.(?:title|text)$/.exec(key)?.[1] ?? [])
  return [...new Set(names)].map((name) => [name, { title: said(name, 'title'), text: said(name, 'text') }])
}

describe.each(completeLanguages)('the problems in %s', (language) => {
  it.each(wordsOf(language))(
    '%s has a title, says what to try, and is said by some code',
    (name, { title, text }) => {
      expect(title).toMatch(/[.?]$/)
      expect(text).toMatch(/[.?]$/)
      const stem = name.replace(/(Here|Empty|Anywhere)$/, '')
      if (!elsewhere.includes(name))
        expect(`${code}\n${screens}`).toMatch(new RegExp(`'(problem\\.)?${stem}'`))
    },
  )

  it.each(wordsOf(language))('%s is said in sentences of at most twelve words', (_name, { title, text }) => {
    for (const sentence of `${title} ${text}`.split(/(?<=[.?])\s/))
      expect(sentence.split(/\s+/).length, sentence).toBeLessThanOrEqual(12)
  })
})

it('every problem that some code says has words', () => {
  const said = [...code.matchAll(/(?:fail|stop|said)\((?:[^()']*, )?'(\w+)'/g)].map(([, name]) => name ?? '')
  const named = [...code.matchAll(/'problem\.(\w+)'/g)].map(([, name]) => name ?? '')
  const names = wordsOf('en').map(([name]) => name)
  for (const name of [...said, ...named]) {
    if (name === 'fix') continue
    expect(
      names.some((known) => known.startsWith(name)),
      name,
    ).toBe(true)
  }
  expect(said.length).toBeGreaterThan(10)
})
