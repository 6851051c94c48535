import { fetchWords } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import { afterAll, expect, test } from 'vitest'
import { doorName, number, tryEnd } from './messages.ts'

afterAll(() => language.speak('en'))

test.each([
  ['en', 'to the left'],
  ['de', 'nach links'],
] as const)('in %s a door of a grid is named by its side in that language', async (locale, side) => {
  await language.speak(locale)
  await fetchWords('races')
  expect(doorName('left', 7)).toBe(side)
  expect(doorName(null, 7)).toBe('7')
})

test('a reward below zero has a minus sign, not a hyphen', async () => {
  await language.speak('de')
  expect([number(-4311.5, 1), number(-16_017), number(7)]).toEqual(['−4.311,5', '−16.017', '7'])
  await language.speak('en')
  expect(number(-4311.5, 1)).toBe('−4,311.5')
})

test('the end of a try has its number and its moves', async () => {
  await language.speak('de')
  await fetchWords('races')
  const tried = { states: [3, 5, 0, 1], stars: 50, falls: 0, atGoal: true }
  expect(tryEnd({ tries: [tried] })).toBe('Versuch 1: 3 Züge. Wie gut war die letzte Tür?')
})
