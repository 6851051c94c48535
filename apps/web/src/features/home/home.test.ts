import type { Project } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { allCards, loadGoals } from '#content/cards.ts'
import type { Listed } from '#storage/projects.ts'
import { friendship } from '#storage/testing/sample.ts'
import { language } from '#words/language.svelte.ts'
import {
  bedOf,
  cardsIn,
  chapterOnShow,
  chaptersOf,
  firstSentence,
  isDone,
  nextOf,
  place,
  recentOf,
  type BedCard,
} from './home.ts'

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

  test('is a card with a single start place as long as it was not reached from there', () => {
    expect(nextOf([card('one place', 0, 1), card('fear', 1, 3)])?.label).toBe('one place')
    expect(nextOf([card('one place', 1, 1), card('fear', 1, 3)])?.label).toBe('fear')
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
  expect(firstSentence(goal)).toBe('Bo has only one try.')
  const german = 'Sperre die Strecke zwischen 2 und 3. Lass Bo dann lernen und fahren.'
  expect(firstSentence(german)).toBe('Sperre die Strecke zwischen 2 und 3.')
  expect(firstSentence('')).toBe('')
})

test('the first sentence of each card is the one that Intl.Segmenter finds', async () => {
  const all = Object.values(await loadGoals()).flatMap((goals) => Object.entries(goals ?? {}))
  expect(all.length).toBeGreaterThan(60)
  for (const [locale, goal] of all) {
    const [first] = new Intl.Segmenter(locale, { granularity: 'sentence' }).segment(goal)
    expect(firstSentence(goal)).toBe(first!.segment.trim())
  }
})

describe('the cards of a bed', () => {
  const goals = { friendship: { en: 'Drive to the square. Then stay.', de: 'Fahr hin. Dann bleib.' }, fear: { en: 'Only English.' } } // prettier-ignore
  const kept = (project: Partial<Project>, changed = 5): Listed => ({
    ...{ id: 'friendship', changed },
    project: { ...friendship, ...project },
  })

  test('are those of the content, each with the number and address of its own', () => {
    const bed = bedOf('network', [], goals)
    const own = allCards.filter((one) => one.bed === 'network')
    expect(bed.map(({ number }) => number)).toEqual(own.map(({ code }) => code.split(' ')[1]))
    expect(bed.map(({ href }) => href)).toEqual(own.map(({ id }) => `/lab/${id}`))
    expect(new Set(bedOf('drive', [], goals).map(({ number }) => number))).toEqual(new Set(['']))
    expect(bed.map(({ closed }) => closed)).toEqual(own.map(() => false))
  })

  test('lie in the groups of their cards', () => {
    for (const bed of ['network', 'q-learning', 'sorting', 'drive'] as const)
      expect(bedOf(bed, [], goals).map(({ group }) => group)).toEqual(
        allCards.filter((one) => one.bed === bed).map(({ group }) => group ?? null),
      )
    expect(allCards.some(({ group }) => group !== undefined)).toBe(true)
  })

  test('have a topic in the language, else in English, else none', async () => {
    const goalOf = (label: string) =>
      bedOf('network', [], goals).find(({ href }) => href === `/lab/${label}`)!.goal
    expect([goalOf('friendship'), goalOf('fear'), goalOf('caution')]).toEqual([
      ...['Drive to the square.', 'Only English.', ''],
    ])
    await language.speak('de')
    expect([goalOf('friendship'), goalOf('fear')]).toEqual(['Fahr hin.', 'Only English.'])
    await language.speak('en')
  })

  test('have been solved from so many start places, each counted once, on whichever project', () => {
    const works = [
      kept({ progress: { starts: [0, 1], hints: 0 } }),
      kept({ progress: { starts: [1], hints: 0 } }),
    ]
    const levelOf = (all: readonly Listed[], id: string) =>
      bedOf('network', all, goals).find(({ href }) => href === `/lab/${id}`)!.level
    const { starts } = allCards.find(({ id }) => id === 'friendship')!
    expect(levelOf(works, 'friendship')).toEqual({ passed: 2, of: starts })
    expect(levelOf(works, 'fear').passed).toBe(0)
    expect(levelOf([kept({})], 'friendship').passed).toBe(0)
  })

  test('lead on from works on this device; a card that somebody has made is told apart', () => {
    const { card: _, ...free } = friendship
    const own = { ...free, name: 'Mine', ownCard: { draft: true } } as unknown as Project
    const [work, draft, finished] = recentOf([
      kept({}),
      { id: 'card-1', changed: 7, project: own },
      { id: 'card-2', changed: 8, project: { ...own, ownCard: {} } as unknown as Project },
    ])
    expect(work).toMatchObject({ href: '/lab/friendship', when: 5, isCard: false })
    expect(draft).toMatchObject({ href: '/lab/free?p=card-1', name: 'Mine', isCard: false })
    expect(finished!.isCard).toBe(true)
  })

  test('that lead to another place have no goals and no level', () => {
    expect(place('/race', 'Races', 'race.svg')).toMatchObject({
      ...{ href: '/race', label: 'Races', picture: 'race.svg', number: '', goal: '', group: null },
      level: { passed: 0, of: 0 },
    })
    expect(isDone({ ...place('/race', '', ''), level: { passed: 1, of: 1 } })).toBe(true)
  })
})
