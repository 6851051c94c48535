import { readPlan, writePlan } from '@botgarten/experiments/study'
import { beforeAll, expect, test } from 'vitest'
import { allCards } from '#content/cards.ts'
import { fetchWords } from '#words/message.ts'
import { Making } from './making.svelte.ts'

beforeAll(() => fetchWords('study'))

test('a study begins with the first three cards of each way of learning, and without a title', () => {
  const { draft } = new Making()
  const first = (bed: string) => allCards.filter((card) => card.bed === bed).slice(0, 3)
  expect(draft.modules.map(({ cards }) => cards)).toEqual(
    ['network', 'q-learning', 'sorting'].map((bed) => first(bed).map(({ id }) => id)),
  )
  expect(draft.modules.every(({ cards }) => cards.length > 0)).toBe(true)
  expect([draft.title, draft.maps, draft.level]).toEqual(['', null, null])
})

test('a study with a title and a word is a plan that is read again, under a name for a file', () => {
  const making = new Making()
  making.draft.title = 'Räder & Netze, 5b!'
  making.draft.word = 'stone'
  expect(making.plan).toMatchObject({ botgarten: 'study', version: 1, title: 'Räder & Netze, 5b!' })
  // Without the marks of letters, small, a hyphen for all others and none at the ends.
  expect(making.plan!.id).toBe('ra-der-netze-5b')
  expect(readPlan(JSON.parse(writePlan(making.plan!)))).toEqual(making.plan)
  making.draft.title = '?!'
  expect(making.plan!.id).toBe('study')
})

test('a new module has the free lab and a new name', () => {
  const making = new Making()
  making.add()
  making.remove(0)
  making.add()
  const added = making.draft.modules.filter(({ cards }) => cards.includes('free'))
  expect(added.map(({ cards }) => cards)).toEqual([['free'], ['free']])
  const ids = making.draft.modules.map(({ id }) => id)
  expect(new Set(ids).size).toBe(4)
})

test('all maps chosen are the same as none left out', () => {
  const making = new Making()
  making.toggleMap('mars', ['mars', 'city'])
  expect(making.draft.maps).toEqual(['city'])
  making.toggleMap('mars', ['mars', 'city'])
  expect(making.draft.maps).toBeNull()
})
