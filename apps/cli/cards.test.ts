import { expect, it } from 'vitest'
import { inOneLine, ordered } from './cards.ts'

it('a card is called by its title in every language that it has, English first', () => {
  const title = { de: 'Freundschaft', en: 'Friendship', fr: 'Amitié' }
  expect(inOneLine(title)).toBe('Friendship / Freundschaft / Amitié')
  expect(JSON.stringify(ordered(title))).toBe('{"en":"Friendship","de":"Freundschaft","fr":"Amitié"}')
})

it('a title that two languages share is said once, and a card may lack English', () => {
  expect(inOneLine({ de: 'Incognito', en: 'Incognito' })).toBe('Incognito')
  expect(inOneLine({ de: 'Freundschaft' })).toBe('Freundschaft')
})
