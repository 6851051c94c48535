import { expect, test } from 'vitest'
import { allItems, cardItem, itemNamed } from './library.ts'
import { numberedName, onPaper, questionsOf, solutionsOf } from './addresses.ts'

test('each item has a way to paper', () => {
  for (const item of allItems) expect(onPaper(item)).toMatch(/\/materials\/[a-z]+\/[a-z0-9-]+\?paper=a4$/)
})

test('what belongs to a module leads to its questions, what belongs to all or none does not', () => {
  expect(questionsOf({ module: 3 })).toMatch(/\/materials\/questions\/3$/)
  expect(questionsOf({ module: 0 })).toBeNull()
})

test.each([
  ['network-cards', 'solutions-network'],
  ['q-city', 'solutions-q-learning'],
  ['sorting-cards-lab', 'solutions-sorting'],
  ['first-drive-cards', 'solutions-first-drive'],
])('the cards of %s lead to %s', (cards, solutions) => {
  expect(solutionsOf(itemNamed(cards)!)?.id).toBe(solutions)
})

test('what is no card has no solutions', () => {
  expect(solutionsOf(itemNamed('q-program')!)).toBeNull()
})

test.each([
  ['forward', 'all'],
  ['friendship', 'supervised'],
  ['railway', 'reinforcement'],
  ['tidy-up', 'unsupervised'],
])('%s is an item by itself, in the colours of its way of learning', (id, way) => {
  expect(cardItem(id)).toMatchObject({ id, kind: 'card', way, paper: 'a5' })
})

test('what is no card is no item', () => {
  expect(cardItem('no-such-card')).toBeUndefined()
})

test('what a link leads to is named on paper without saying its number or its name twice', () => {
  const name = numberedName('card:friendship', 'NN 5')
  expect(numberedName('card:friendship', name)).toBe('NN 5')
  expect(numberedName('card:friendship', 'this card')).toBe(`NN 5: ${name}`)
})
