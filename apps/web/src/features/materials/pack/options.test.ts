import { expect, test } from 'vitest'
import { packOptionsIn } from './options.ts'

const read = (search: string) => packOptionsIn(new URLSearchParams(search))

test('where nothing is said: one set for 24 children in the language of the page, with answers', () => {
  expect(read('')).toEqual({ children: 24, answers: 'with', grade: null, sets: 1, languages: [] })
})

test('everything can be said; a language that is named twice is printed once', () => {
  expect(read('children=17&answers=apart&grade=4&sets=3&languages=de,en,de')).toEqual({
    ...{ children: 17, answers: 'apart', grade: 4, sets: 3, languages: ['de', 'en'] },
  })
})

test.each(['children=0', 'children=100', 'children=2.5', 'grade=14', 'sets=21', 'sets=-1', 'sets=many'])(
  '%s: as usual',
  (search) => {
    expect(read(search)).toEqual(read(''))
  },
)
