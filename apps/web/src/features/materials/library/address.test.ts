import { expect, test } from 'vitest'
import { choiceIn, queryOf } from './address.ts'
import { anything, type Choice } from './choice.ts'

const again = (query: string) => choiceIn(new URLSearchParams(query))

test('who has chosen nothing has a plain address', () => {
  expect(queryOf(anything)).toBe('')
  expect(again('')).toEqual(anything)
})

test('whatever is chosen is found again by its address', () => {
  const choice: Choice = {
    ...{ words: 'Bo & Piep?', grade: 5, minutes: 45, teachers: false },
    ...{ modules: [2, 4], shelves: ['cards', 'sheets'], ways: ['supervised'], socials: ['pairs', 'class'] },
  }
  expect(again(queryOf(choice))).toEqual(choice)
})

test('an address can be read by a person', () => {
  expect(queryOf({ ...anything, modules: [2], shelves: ['cards', 'sheets'] })).toBe(
    '?module=2&kind=cards,sheets',
  )
})

test('what nobody can choose is left out', () => {
  expect(again('?module=7,2&kind=songs&grade=99&minutes=many&way=all')).toEqual({ ...anything, modules: [2] })
})
