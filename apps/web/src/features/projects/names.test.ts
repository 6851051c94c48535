import { expect, test } from 'vitest'
import { titleOf } from '#content/names.ts'
import { cardName, damagedName, placedIn } from './names.ts'

test('a damaged project is called as the child has called it, or like its card', () => {
  expect(damagedName('My Bo', { card: 'friendship' })).toBe('My Bo')
  expect(damagedName('friendship', { card: 'friendship' })).toBe(titleOf('friendship'))
  expect(damagedName(null, { card: 'friendship' })).toBeNull()
})

test.each([null, undefined, 7, 'text', []])('a name is shown although the rest is %j', (raw) => {
  expect(damagedName('My Bo', raw)).toBe('My Bo')
})

test('the playground of a damaged project is read, and no other one than sorting is', () => {
  expect(placedIn({ card: 'tidy-up', playground: 'sorting' })).toEqual({
    card: 'tidy-up',
    playground: 'sorting',
  })
  expect(placedIn({ card: 'tidy-up', playground: 'kitchen' })).toEqual({ card: 'tidy-up' })
})

test('a project has the name of its card, unless it belongs elsewhere', () => {
  expect(cardName({ card: 'friendship' })).toBe(titleOf('friendship'))
  expect(cardName({})).toBeNull()
  expect(cardName({ card: 'a card of a later version' })).toBeNull()
  expect(cardName({ card: 'tidy-up', playground: 'sorting' })).toBeNull()
})
