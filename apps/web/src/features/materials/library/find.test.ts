import { beforeAll, describe, expect, test } from 'vitest'
import { fetchMaterials, offeredItems } from '../library.ts'
import { language } from '#words/language.svelte.ts'
import { anything } from './choice.ts'
import { countWith, foundBy, marked, pagesFor } from './find.ts'

beforeAll(async () => {
  await fetchMaterials()
})

const first = (words: string) => foundBy(words)[0]?.item.id

describe('the library finds', () => {
  test.each([
    ['friendship', 'friendship'],
    ['and fear', 'friendship-and-fear'],
    ['nn 5', 'friendship'],
    ['3.1', 'my-knobs'],
    ['Q1', 'q-railway'],
    ['net from strings', 'net-from-strings'],
  ])('by %j first %s', (words, id) => {
    expect(first(words)).toBe(id)
  })

  test('by kind and by other words for it', () => {
    const kinds = (words: string) => new Set(foundBy(words).map(({ item }) => item.kind))
    expect(kinds('presentation')).toContain('slides')
    expect(kinds('handout')).toContain('worksheet')
    expect(kinds('no computer')).toContain('kit')
  })

  // Words of the thesis for its cards, sheets and settings.
  test.each([
    ['en', 'learning cards', 'network-cards'],
    ['en', 'flowchart', 'q-flow'],
    ['en', 'Q&A', 'q-questions'],
    ['en', 'Raspberry Pi', 'running-a-class'],
    ['de', 'Lernkarten', 'network-cards'],
    ['de', 'Flussdiagramm', 'q-flow'],
    ['de', 'Q&A', 'q-questions'],
    ['de', 'Raspberry', 'running-a-class'],
  ] as const)('in "%s" by %j among the first three %s', async (locale, words, id) => {
    await language.speakForNow(locale)
    await fetchMaterials()
    expect(
      foundBy(words)
        .slice(0, 3)
        .map(({ item }) => item.id),
    ).toContain(id)
    await language.speakForNow('en')
  })

  test.each([
    ['en', 'hyperparameters'],
    ['de', 'Hyperparameter'],
  ] as const)('in "%s" by %j the materials about the settings of learning', async (locale, words) => {
    await language.speakForNow(locale)
    await fetchMaterials()
    const ids = foundBy(words).map(({ item }) => item.id)
    expect(ids).toEqual(expect.arrayContaining(['q-program', 'learn-from-experience']))
    await language.speakForNow('en')
  })

  test('the page of the questionnaires by their names, and no page for no words', () => {
    for (const words of ['questionnaire', 'survey', 'evaluation'])
      expect(pagesFor(words).map(({ href }) => href)).toContain('/questionnaires')
    expect(pagesFor('')).toEqual([])
    expect(pagesFor('friendship')).toEqual([])
  })

  test('everything, where nothing is looked for', () => {
    expect(foundBy(' ')).toHaveLength(offeredItems.length)
    expect(foundBy('qwertz')).toEqual([])
  })
})

test('behind a filter stands how many would be there with it alone', () => {
  const found = foundBy('')
  const cards = found.filter(({ item }) => item.kind === 'card' || item.kind === 'observation').length
  expect(countWith(found, { ...anything, shelves: ['slides'] }, { shelves: ['cards'] })).toBe(cards)
})

test('a long line is cut to what stands around the first mark', () => {
  const words = `${'one two '.repeat(20)}fear ${'three four '.repeat(20)}`
  const at = words.indexOf('fear')
  const { before, after, pieces } = marked({ words, marks: [[at, at + 4]] })
  expect([before, after]).toEqual([true, true])
  expect(pieces.filter(({ on }) => on)).toEqual([{ text: 'fear', on: true }])
  expect(pieces.map(({ text }) => text).join('').length).toBeLessThanOrEqual(70)
  expect(marked({ words: 'fear', marks: [[0, 4]] })).toEqual({
    ...{ before: false, after: false },
    pieces: [{ text: 'fear', on: true }],
  })
})

test('a third of a cut line at the most is before the first mark, from the beginning of a word', () => {
  const words = `${'x '.repeat(100)}fear${' x'.repeat(100)}`
  const [before] = marked({ words, marks: [[200, 204]] }).pieces
  // A third of 64 letters is 21; a word begins at every second letter.
  expect(before).toEqual({ text: 'x '.repeat(10), on: false })
})
