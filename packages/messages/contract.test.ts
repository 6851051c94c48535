// The folder content/words: every language says everything, with the same facts.
import { expect, test } from 'vitest'
import { doubledIn, missingIn, unlikeIn, wrongForms } from './check.ts'
import { filesIn, languagesIn, ownTableOf } from './folder.ts'

test('there are languages, the two that others fall back to among them', () => {
  expect(languagesIn()).toEqual(expect.arrayContaining(['de', 'en']))
})

test('every language has every message, in the same file', () => {
  expect(missingIn()).toEqual([])
})

test('no message stands in two files', () => {
  expect(doubledIn()).toEqual([])
})

test('a message has the same facts in every language', () => {
  expect(unlikeIn()).toEqual([])
})

test.each(languagesIn())(
  'sentences that change with a number have every form that "%s" knows',
  (language) => {
    const all = filesIn().flatMap((file) => Object.entries(ownTableOf(file, language)))
    expect(all.flatMap(([key, message]) => wrongForms(language, key, message))).toEqual([])
  },
)
