import { fetchWords } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import { afterAll, expect, test } from 'vitest'
import { doorName } from './messages.ts'

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
