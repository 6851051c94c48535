import { expect, test } from 'vitest'
import {
  allItems,
  allQuestions,
  cardItem,
  fetchItems,
  itemNamed,
  offeredItems,
  questionText,
  targetItem,
  targetOf,
  textOf,
} from './library.ts'

test('words that were not fetched are an error that names them, and are there once they were fetched', async () => {
  const [item, question] = [allItems[0]!, allQuestions[0]!]
  expect(() => textOf(item)).toThrow(`The words of "${item.kind}/${item.id}" are not here.`)
  expect(() => questionText(question.id)).toThrow(`The words of the question "${question.id}" are not here.`)
  await fetchItems()
  expect(textOf(item).title).not.toBe('')
  expect(questionText(question.id)).toBeTruthy()
})

test('every offered item is found again by the name that it is copied by', () => {
  const named = offeredItems.map((item) => targetItem(targetOf(item))?.id)
  expect(named).toEqual(offeredItems.map(({ id }) => id))
})

test('an item and a card of the lab with one name are two things', () => {
  const both = allItems.filter(({ id }) => cardItem(id) !== undefined)
  expect(targetItem('card:friendship')).toEqual(cardItem('friendship'))
  expect(targetItem('item:friendship-and-fear')).toEqual(itemNamed('friendship-and-fear'))
  expect(targetItem('item:friendship')).toBe(itemNamed('friendship'))
  for (const { id } of both) expect(targetItem(`card:${id}`)).not.toEqual(targetItem(`item:${id}`))
})
