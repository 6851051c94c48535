import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { learningOf, programOf } from './programs.ts'

test.each([
  ['friendship', 'start'],
  ['friendship', 'solution'],
])('%s with its %s is the very file of the card', async (card, file) => {
  const shown = await programOf(card, file)
  expect(shown.program).toEqual(content.program(card, file))
  expect(shown.card.card.id).toBe(card)
})

test('the start program of any card comes with the card, whether an item names it or not', async () => {
  expect((await programOf('either-or', 'start')).program).toEqual(content.program('either-or', 'start'))
})

test.each([
  ['no-such-card', 'start'],
  ['friendship', 'wrong/no-such-slip'],
])('"%s" with "%s" is a mistake of the content, and says so', async (card, file) => {
  await expect(programOf(card, file)).rejects.toThrow(`There is no "${file}" of "${card}".`)
})

test('a card for learning by trying is known by what its start program learns', async () => {
  expect(await learningOf('railway', 'start')).toMatchObject({ map: 'railway', start: 3, goal: 1 })
  expect(await learningOf('friendship', 'start')).toBeUndefined()
})
