// The folder content/words: German and English have every message, any other language some, with the same facts.
import { expect, test } from 'vitest'
import { doubledIn, missingIn, unlikeIn, wrongForms } from './check.ts'
import { formsOf } from './message.ts'
import { completeLanguages, filesIn, languagesIn, ownTableOf } from './folder.ts'

test('the languages that are promised complete are there', () => {
  expect(languagesIn()).toEqual(expect.arrayContaining([...completeLanguages]))
})

test('every complete language has every message, in the same file', () => {
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

test('a number and its unit stay on one line: the space between them does not break', () => {
  const breaks = /[\d}] (?:%|°|(?:cm|mm|km|m|s|min|h|GB|MB|kB)(?![\p{L}\p{N}-]))/u
  // A terminal breaks no lines, and the rows of blocks are split at their spaces.
  const shown = filesIn().filter((file) => !['cli', 'doctor'].includes(file))
  const found = languagesIn().flatMap((language) =>
    shown.flatMap((file) =>
      Object.entries(ownTableOf(file, language)).flatMap(([key, message]) =>
        /\.row\d+$/.test(key) ? [] : formsOf(message).filter((form) => breaks.test(form)),
      ),
    ),
  )
  expect(found).toEqual([])
})
