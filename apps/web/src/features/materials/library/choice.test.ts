import type { Item } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { offeredItems } from '../library.ts'
import { anything, fits, shelvesOf, toggled, choiceIn, queryOf, type Choice } from './choice.ts'

const item: Item = {
  ...{ id: 'sheet', kind: 'sheet', audience: 'teachers', grades: [5, 8], minutes: 45 },
  ...{ way: 'supervised', social: 'pairs', module: 2, paper: 'a4', competences: ['a'], unplugged: false },
}
const isIn = (choice: Partial<typeof anything>) => fits(item, { ...anything, ...choice })

test('who says nothing sees everything', () => {
  expect(isIn({})).toBe(true)
})

test('a grade is in from the youngest to the oldest', () => {
  expect([4, 5, 8, 9].map((grade) => isIn({ grade }))).toEqual([false, true, true, false])
})

test('a lesson is long enough or not', () => {
  expect([isIn({ minutes: 45 }), isIn({ minutes: 44 })]).toEqual([true, false])
})

test('one of several ways and of several sizes of groups is enough', () => {
  expect(isIn({ ways: ['unsupervised', 'supervised'], socials: ['alone', 'pairs'] })).toBe(true)
  expect([isIn({ ways: ['unsupervised'] }), isIn({ socials: ['class'] })]).toEqual([false, false])
})

test('one of several modules and of several kinds is enough', () => {
  expect(isIn({ modules: [1, 2], shelves: ['cards', 'sheets'] })).toBe(true)
  expect([isIn({ modules: [3] }), isIn({ shelves: ['cards'] })]).toEqual([false, false])
})

test('what belongs to no module is under none', () => {
  expect(fits({ ...item, module: 0 }, { ...anything, modules: [1, 2, 3, 4] })).toBe(false)
})

test('every item stands on a shelf, what needs no screen on that one too', () => {
  expect(offeredItems.filter((one) => shelvesOf(one).length === 0)).toEqual([])
  expect(shelvesOf({ ...item, kind: 'worksheet', audience: 'pupils', unplugged: true })).toEqual([
    'sheets',
    'unplugged',
  ])
  expect(shelvesOf({ ...item, kind: 'kit' })).toEqual(['unplugged'])
})

test('what belongs to all ways is under none of them: a filter leaves out what it does not name', () => {
  expect(fits({ ...item, way: 'all' }, { ...anything, ways: ['reinforcement'] })).toBe(false)
})

test('children need not see what teachers read', () => {
  expect([isIn({ teachers: false }), isIn({ teachers: true })]).toEqual([false, true])
})

test('a value is put in, and taken out again', () => {
  expect([toggled([1, 2], 3), toggled([1, 2], 2)]).toEqual([[1, 2, 3], [1]])
})

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
