import { describe, expect, test } from 'vitest'
import { cardsIn, chapterOnShow, chaptersOf, firstSentence, isDone, nextOf, type BedCard } from './home.ts'

const card = (label: string, passed: number, of: number): BedCard => ({
  ...{ href: `/lab/${label}`, number: '', label, goal: '', picture: null, group: null },
  level: { passed, of },
})

describe('the card to play next', () => {
  test('is the first that is not done', () => {
    const cards = [card('chameleon', 3, 3), card('incognito', 1, 3), card('caution', 0, 3)]
    expect(nextOf(cards)?.label).toBe('incognito')
  })

  test('is a playground without goals only until another card has been begun', () => {
    expect(nextOf([card('vessels', 0, 0), card('tidy up', 0, 2)])?.label).toBe('vessels')
    expect(nextOf([card('vessels', 0, 0), card('tidy up', 1, 2)])?.label).toBe('tidy up')
  })

  test('is the first one again where all are done', () => {
    expect(nextOf([card('vessels', 0, 0), card('tidy up', 2, 2)])?.label).toBe('vessels')
  })

  test('is one that the teacher has left open, and none where there is none', () => {
    const closed = { ...card('chameleon', 0, 3), closed: true }
    expect(nextOf([closed, card('caution', 0, 3)])?.label).toBe('caution')
    expect(nextOf([closed])).toBeNull()
  })

  test('a playground without goals is never done', () => {
    expect([card('vessels', 0, 0), card('tidy up', 2, 2)].map(isDone)).toEqual([false, true])
  })
})

describe('the chapters of a bed', () => {
  const shown = (label: string, passed: number) => ({
    ...card(label, passed, 3),
    chapter: 'examples' as const,
  })
  const cards = [card('chameleon', 3, 3), card('fear', 0, 3), shown('show me', 0)]

  test('are those that have cards, in their order', () => {
    expect(chaptersOf(cards)).toEqual(['hand', 'examples'])
    expect(cardsIn(cards, 'examples').map(({ label }) => label)).toEqual(['show me'])
  })

  test('begin with the one of the card to play next, until another is chosen', () => {
    expect(chapterOnShow(cards, undefined)).toBe('hand')
    expect(chapterOnShow(cards, 'examples')).toBe('examples')
    expect(chapterOnShow([card('chameleon', 3, 3), shown('show me', 0)], undefined)).toBe('examples')
  })

  test('never show one that has no cards', () => {
    expect(chapterOnShow(cards, 'trying')).toBe('hand')
  })
})

test('a tile shows the first sentence of what its card is about', () => {
  const goal = 'Bo has only one try. Give Bo more of them, until Bo drives the short way.'
  expect(firstSentence(goal, 'en')).toBe('Bo has only one try.')
  const german = 'Sperre die Strecke zwischen 2 und 3. Lass Bo dann lernen und fahren.'
  expect(firstSentence(german, 'de')).toBe('Sperre die Strecke zwischen 2 und 3.')
  expect(firstSentence('', 'en')).toBe('')
})
